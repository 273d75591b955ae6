# The library that draws the charts of pages: plotly.js without maps and three dimensions, MIT
# licence. Fetched once per build folder; part of the program, so that pages need no network.
# npm fetches it: registry, mirror and proxy are those of the machine.

set(TRICONTACT_CHARTS "" CACHE FILEPATH "Package of the chart library, if it is not to be fetched")

set(charts_name plotly.js-cartesian-dist-min)
set(charts_version 4.1.1)
set(charts_archive ${charts_name}-${charts_version}.tgz)
set(charts_sha512 a3c1ab15ebac9dcc012316c1ca7449a58e29920541e9c68cf892e9c2b2d86dbb0eedd67c149f9254dd85afe2fb9221bf67ac383f93b426eb3f42be4479f1d57a)

# pack_charts(folder): lets npm write the package into the folder.
function(pack_charts folder)
    string(CONCAT remedy
        "Without npm or a network, fetch it elsewhere (npm pack ${charts_name}@${charts_version}) "
        "and configure with -DTRICONTACT_CHARTS=path/to/${charts_archive}")
    find_program(TRICONTACT_NPM npm DOC "Fetches the chart library")
    if(NOT TRICONTACT_NPM)
        message(FATAL_ERROR "npm, which fetches the chart library, is not there. ${remedy}")
    endif()
    message(STATUS "Fetching ${charts_name} ${charts_version} by npm")
    file(REMOVE_RECURSE ${folder}/fetched)
    file(MAKE_DIRECTORY ${folder}/fetched)
    execute_process(COMMAND ${TRICONTACT_NPM} pack --loglevel=error ${charts_name}@${charts_version}
                    WORKING_DIRECTORY ${folder}/fetched
                    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(code OR NOT EXISTS ${folder}/fetched/${charts_archive})
        message(FATAL_ERROR "npm pack ${charts_name}@${charts_version} failed: ${output}. ${remedy}")
    endif()
    file(RENAME ${folder}/fetched/${charts_archive} ${folder}/${charts_archive})
endfunction()

# fetch_charts(variable): sets it to the folder of plotly-cartesian.min.js and its LICENSE.
function(fetch_charts variable)
    set(folder ${PROJECT_BINARY_DIR}/charts)
    set(archive ${TRICONTACT_CHARTS})
    if(NOT archive)
        set(archive ${folder}/${charts_archive})
        if(NOT EXISTS ${archive})
            pack_charts(${folder})
        endif()
    endif()
    if(NOT EXISTS ${archive})
        message(FATAL_ERROR "TRICONTACT_CHARTS: there is no ${archive}")
    endif()
    file(SHA512 ${archive} sha512)
    if(NOT sha512 STREQUAL charts_sha512)
        message(FATAL_ERROR "${archive} is not the package ${charts_name} ${charts_version}: its SHA-512 is "
                            "${sha512}, not ${charts_sha512}. Remove it")
    endif()
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${folder})
    set(${variable} ${folder}/package PARENT_SCOPE)
endfunction()
