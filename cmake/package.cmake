# What `make install` installs of the library, so that find_package(morskin) works: one archive of
# all modules and the headers of morskin/ that its users need, which include nothing but the
# standard library.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/morskin)

foreach(module ${library_modules})
  list(APPEND library_objects $<TARGET_OBJECTS:${module}>)
endforeach()
add_library(installed_library STATIC ${library_objects})
set_target_properties(installed_library PROPERTIES
  LINKER_LANGUAGE CXX OUTPUT_NAME morskin EXPORT_NAME morskin
  ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/package)
target_compile_features(installed_library INTERFACE cxx_std_20)
target_link_libraries(installed_library PRIVATE ZLIB::ZLIB LibArchive::LibArchive
                                                Threads::Threads)
target_sources(installed_library PUBLIC FILE_SET headers TYPE HEADERS
  BASE_DIRS ${PROJECT_SOURCE_DIR}
  FILES morskin/morskin.h morskin/mesh_method.h morskin/molecule.h morskin/features.h)
install(TARGETS installed_library EXPORT morskin_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET headers DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

file(WRITE ${PROJECT_BINARY_DIR}/package/morskinConfig.cmake
"include(CMakeFindDependencyMacro)
find_dependency(ZLIB)
find_dependency(LibArchive)
find_dependency(Threads)
include(\${CMAKE_CURRENT_LIST_DIR}/morskinTargets.cmake)
")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/morskinConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/morskinConfig.cmake
              ${PROJECT_BINARY_DIR}/package/morskinConfigVersion.cmake
        DESTINATION ${package_folder})
install(EXPORT morskin_targets NAMESPACE morskin:: FILE morskinTargets.cmake
        DESTINATION ${package_folder})

# The same for pkg-config. All is found from the file itself, so that the tree may be moved.
string(REGEX REPLACE "[^/]+" ".." path_to_prefix ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
configure_file(cmake/morskin.pc.in ${PROJECT_BINARY_DIR}/package/morskin.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/morskin.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# What is read, and the examples with their molecules (examples/molecules is a link).
install(FILES LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY examples/cpp examples/learning examples/python
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples PATTERN __pycache__ EXCLUDE)
install(PROGRAMS examples/shell/mesh_all.sh DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/shell)
install(FILES examples/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
install(DIRECTORY bench/molecules DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
