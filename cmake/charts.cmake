# The library that draws the charts of pages: plotly.js without maps and three dimensions, MIT
# licence. Fetched once per build folder; part of the program, so that pages need no network.

set(TRICONTACT_CHARTS "" CACHE FILEPATH "Package of the chart library, if it is not to be fetched")

set(charts_version 4.1.1)
set(charts_archive plotly.js-cartesian-dist-min-${charts_version}.tgz)
set(charts_url https://registry.npmjs.org/plotly.js-cartesian-dist-min/-/${charts_archive})
set(charts_sha512 a3c1ab15ebac9dcc012316c1ca7449a58e29920541e9c68cf892e9c2b2d86dbb0eedd67c149f9254dd85afe2fb9221bf67ac383f93b426eb3f42be4479f1d57a)

# fetch_charts(variable): sets it to the folder of plotly-cartesian.min.js and its LICENSE.
function(fetch_charts variable)
    set(folder ${PROJECT_BINARY_DIR}/charts)
    set(archive ${TRICONTACT_CHARTS})
    if(NOT archive)
        set(archive ${folder}/${charts_archive})
        if(NOT EXISTS ${archive})
            message(STATUS "Fetching ${charts_url}")
            file(DOWNLOAD ${charts_url} ${archive}.part STATUS status)
            list(GET status 0 code)
            if(code)
                list(GET status 1 reason)
                file(REMOVE ${archive}.part)
                message(FATAL_ERROR "${charts_url}: ${reason}. Without a network, fetch it elsewhere "
                                    "and configure with -DTRICONTACT_CHARTS=path/to/${charts_archive}")
            endif()
            file(RENAME ${archive}.part ${archive})
        endif()
    endif()
    if(NOT EXISTS ${archive})
        message(FATAL_ERROR "TRICONTACT_CHARTS: there is no ${archive}")
    endif()
    file(SHA512 ${archive} sha512)
    if(NOT sha512 STREQUAL charts_sha512)
        message(FATAL_ERROR "${archive} is not the package ${charts_url}: its SHA-512 is ${sha512}, "
                            "not ${charts_sha512}. Remove it")
    endif()
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${folder})
    set(${variable} ${folder}/package PARENT_SCOPE)
endfunction()
