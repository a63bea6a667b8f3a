# SUNDIALS 6 or 7: the targets SUNDIALS::ida and SUNDIALS::nvecserial, and STRANDYN_IDA_CHECKPOINTS, which says whether the
# memory of IDA is known. An installed SUNDIALS comes first; else what tools/deps.sh has unpacked below build/deps.

# sundials_setting(NAME HEADERS VARIABLE): what sundials_config.h defines NAME as; empty where it does not.
function(sundials_setting name headers variable)
  file(STRINGS ${headers}/sundials/sundials_config.h line REGEX "^#define ${name}( |$)" LIMIT_COUNT 1)
  string(REGEX REPLACE "^#define ${name} *\"?([^\"]*)\"?$" "\\1" value "${line}")
  set(${variable} "${value}" PARENT_SCOPE)
endfunction()

set(unpacked ${PROJECT_SOURCE_DIR}/build/deps/sundials)
find_path(sundials_headers ida/ida.h NO_CACHE)
if(NOT sundials_headers AND EXISTS ${unpacked}/include/ida/ida.h)
  set(sundials_headers ${unpacked}/include)
endif()
if(NOT sundials_headers)
  message(FATAL_ERROR "SUNDIALS is missing: install it (Debian: libsundials-dev) or let tools/run fetch what it needs")
endif()
sundials_setting(SUNDIALS_VERSION ${sundials_headers} sundials_version)
sundials_setting(SUNDIALS_MPI_ENABLED ${sundials_headers} sundials_mpi)
set(sundials_wants_mpi OFF)  # in its headers and in its configuration
if(sundials_version VERSION_GREATER_EQUAL 7 AND sundials_mpi)
  set(sundials_wants_mpi ON)
endif()

if(sundials_headers STREQUAL ${unpacked}/include)
  # The archive of IDA holds the serial vector and Newton's method; that of the core is a part of it before version 7.
  add_library(SUNDIALS::ida INTERFACE IMPORTED)
  add_library(SUNDIALS::nvecserial INTERFACE IMPORTED)
  target_include_directories(SUNDIALS::ida INTERFACE ${sundials_headers})
  target_link_libraries(SUNDIALS::ida INTERFACE ${unpacked}/lib/libsundials_ida.a)
  if(EXISTS ${unpacked}/lib/libsundials_core.a)
    target_link_libraries(SUNDIALS::ida INTERFACE ${unpacked}/lib/libsundials_core.a)
  endif()
  if(sundials_wants_mpi)
    add_library(strandyn_without_mpi STATIC cmake/without_mpi/without_mpi.cpp)
    target_include_directories(SUNDIALS::ida INTERFACE ${PROJECT_SOURCE_DIR}/cmake/without_mpi)
    target_link_libraries(SUNDIALS::ida INTERFACE strandyn_without_mpi)
  endif()
  target_link_libraries(SUNDIALS::nvecserial INTERFACE SUNDIALS::ida)
else()
  if(sundials_wants_mpi)
    enable_language(C)  # the configuration names the targets of MPI before it looks for them
    find_package(MPI REQUIRED COMPONENTS C CXX)
  endif()
  find_package(SUNDIALS 6.4 REQUIRED COMPONENTS ida nvecserial)
endif()

set(STRANDYN_IDA_CHECKPOINTS OFF)
if(sundials_version VERSION_GREATER_EQUAL 6.4 AND sundials_version VERSION_LESS 6.5 AND
   EXISTS ${sundials_headers}/ida/ida_impl.h)
  set(STRANDYN_IDA_CHECKPOINTS ON)
endif()
message(STATUS "SUNDIALS ${sundials_version} in ${sundials_headers}, checkpoints of IDA: ${STRANDYN_IDA_CHECKPOINTS}")
