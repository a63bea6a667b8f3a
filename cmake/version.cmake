# What summary.json says about the program: version, git revision, compiler.
find_package(Git QUIET)
set(STRANDYN_REVISION "unknown")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -c safe.directory=${PROJECT_SOURCE_DIR} -C ${PROJECT_SOURCE_DIR} describe --always --dirty --abbrev=12
                  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0)
    set(STRANDYN_REVISION ${described})
  endif()
endif()
# A new commit changes the revision: configure again when the branch moves.
foreach(file HEAD logs/HEAD)
  if(EXISTS ${PROJECT_SOURCE_DIR}/.git/${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/.git/${file})
  endif()
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/cmake/version.hpp.in ${PROJECT_BINARY_DIR}/include/strandyn/version.hpp)
