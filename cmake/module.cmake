# add_module(NAME HEADERS ... SOURCES ... USES ... [EDGES ...])
#
# One static library per folder. HEADERS must compile alone; those that begin with "// Inside"
# belong to the module's own sources and are not listed. The list after USES is the module's whole
# permission to include: `make lint` fails on an include against the module order. EDGES names
# outside libraries (zlib) that the sources, never the headers, need.
function(add_module name)
  cmake_parse_arguments(ARG "" "" "HEADERS;SOURCES;USES;EDGES" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  add_library(morskin::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES OUTPUT_NAME morskin_${name}
                                           VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(${name} PUBLIC FILE_SET headers TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
                                FILES ${ARG_HEADERS})
  target_link_libraries(${name} PUBLIC ${ARG_USES} Eigen3::Eigen)
  foreach(edge ${ARG_EDGES})
    target_link_libraries(${name} PRIVATE ${edge})
  endforeach()
  apply_project_options(${name})
endfunction()

# Libraries of templates that a program beside ours may use too, in another version or with other
# flags. The linker takes one copy of a function for both, so ours have names of their own.
set(own_names Eigen=morskin_Eigen gemmi=morskin_gemmi tao=morskin_tao
              fast_float=morskin_fast_float)

# Warnings are errors with the compilers that were tried, GCC 12 and 14; later ones may have others.
set(werror -Werror)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU OR CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 15)
  set(werror "")
endif()

# Contraction is off, for users of the headers too, so that every build rounds alike (same input,
# same bytes). Every object may go into a shared library, such as Python's module; all have the
# same flags for that, since they share a precompiled header. Without interposition the compiler
# may inline as it does in a program.
function(apply_project_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_definitions(${target} PUBLIC ${own_names})
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow ${werror}
                                           -fPIC -fno-semantic-interposition
                                   PUBLIC -ffp-contract=off)
  if(NOT target STREQUAL eigen_headers)
    target_precompile_headers(${target} REUSE_FROM eigen_headers)
  endif()
endfunction()

# Eigen takes longer to read than most of our sources to compile, so it is read once for all.
function(add_eigen_headers)
  file(WRITE ${PROJECT_BINARY_DIR}/generated/eigen_headers.cpp "")
  add_library(eigen_headers OBJECT ${PROJECT_BINARY_DIR}/generated/eigen_headers.cpp)
  target_link_libraries(eigen_headers PRIVATE Eigen3::Eigen)
  apply_project_options(eigen_headers)
  target_precompile_headers(eigen_headers PRIVATE <Eigen/Geometry>)
endfunction()
