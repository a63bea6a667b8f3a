# The interactive plots of a page: a library of the npm registry, in the version and with the checksum of the lock file,
# fetched when the build is set up and put into the program. Nothing of it is kept in the sources. Without npm, or where
# it cannot be fetched, the program builds all the same and pages keep their static figures.
option(STRANDYN_INTERACTIVE "Put the library of interactive plots into the program, where npm can fetch it" ON)

function(strandyn_embed_page target)
  set(from ${PROJECT_SOURCE_DIR}/src/report/page)
  set(folder ${PROJECT_BINARY_DIR}/page)
  set(library ${folder}/node_modules/plotly.js-cartesian-dist-min/plotly-cartesian.min.js)
  foreach(file package.json package-lock.json plots.js)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${from}/${file})
  endforeach()
  find_program(STRANDYN_NPM npm)
  if(STRANDYN_INTERACTIVE AND STRANDYN_NPM)
    file(SHA256 ${from}/package-lock.json lock)
    set(fetched "")
    if(EXISTS ${folder}/fetched)
      file(READ ${folder}/fetched fetched)
    endif()
    if(NOT (EXISTS ${library} AND fetched STREQUAL lock))
      file(COPY ${from}/package.json ${from}/package-lock.json DESTINATION ${folder})
      execute_process(COMMAND ${STRANDYN_NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
                              --fetch-timeout=30000 WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed
                      OUTPUT_QUIET ERROR_VARIABLE said TIMEOUT 120)
      if(failed)
        message(STATUS "pages of results without interactive plots: npm could not fetch what draws them")
      else()
        file(WRITE ${folder}/fetched ${lock})
      endif()
    endif()
  endif()
  set(text "")
  set(script "")
  if(STRANDYN_INTERACTIVE AND STRANDYN_NPM AND EXISTS ${library})
    set(text "#include \"plotly.inc\"\n")
    set(script "#include \"plots.inc\"\n")
    strandyn_literal(${library} ${PROJECT_BINARY_DIR}/generated/plotly.inc)
    strandyn_literal(${from}/plots.js ${PROJECT_BINARY_DIR}/generated/plots.inc)
  endif()
  set(made ${PROJECT_BINARY_DIR}/generated/page_scripts.cpp)
  file(CONFIGURE OUTPUT ${made} @ONLY CONTENT "// Made by the build from src/report/page.
#include \"strandyn/report/interactive.hpp\"
namespace strandyn::report {
PageScripts page_scripts() {
  static const char library[] =
${text}      \"\";
  static const char plots[] =
${script}      \"\";
  return {{library, sizeof(library) - 1}, {plots, sizeof(plots) - 1}};
}
}  // namespace strandyn::report
")
  target_sources(${target} PRIVATE ${made})
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated)
endfunction()

# A file as one string literal of C++.
function(strandyn_literal from to)
  file(READ ${from} text)
  file(WRITE ${to} "R\"page(${text})page\"\n")
endfunction()
