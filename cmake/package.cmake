# What `make install` adds so that find_package(morskin) works: the targets morskin::morskin, of
# all the library's modules and the baselines, and the outside packages they need.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/morskin)

file(WRITE ${PROJECT_BINARY_DIR}/package/morskinConfig.cmake
"include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
find_dependency(ZLIB)
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
