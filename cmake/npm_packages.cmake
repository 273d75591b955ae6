# What pages draw with, fetched once per build folder; part of the program, so that pages need no network. npm
# fetches it: registry, mirror and proxy are those of the machine.

# pack_by_npm(folder package archive remedy): lets npm write the archive of the package, name@version, into the folder.
function(pack_by_npm folder package archive remedy)
    find_program(TRICONTACT_NPM npm DOC "Fetches what pages draw with")
    if(NOT TRICONTACT_NPM)
        message(FATAL_ERROR "npm, which fetches ${package}, is not there. ${remedy}")
    endif()
    message(STATUS "Fetching ${package} by npm")
    file(REMOVE_RECURSE ${folder}/fetched)
    file(MAKE_DIRECTORY ${folder}/fetched)
    execute_process(COMMAND ${TRICONTACT_NPM} pack --loglevel=error ${package}
                    WORKING_DIRECTORY ${folder}/fetched
                    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(code OR NOT EXISTS ${folder}/fetched/${archive})
        message(FATAL_ERROR "npm pack ${package} failed: ${output}. ${remedy}")
    endif()
    file(RENAME ${folder}/fetched/${archive} ${folder}/${archive})
endfunction()

# fetch_npm_package(name version sha512 OPTION setting FOLDER folder): unpacks the package into folder/package. Who has no
# network names an archive by -D<setting>=path.
function(fetch_npm_package name version sha512)
    cmake_parse_arguments(ARG "" "OPTION;FOLDER" "" ${ARGN})
    set(${ARG_OPTION} "" CACHE FILEPATH "Archive of ${name} ${version}, if it is not to be fetched")
    set(archive_name ${name}-${version}.tgz)
    set(archive ${${ARG_OPTION}})
    if(NOT archive)
        set(archive ${ARG_FOLDER}/${archive_name})
        if(NOT EXISTS ${archive})
            string(CONCAT remedy "Without npm or a network, fetch it elsewhere (npm pack ${name}@${version}) "
                                 "and configure with -D${ARG_OPTION}=path/to/${archive_name}")
            pack_by_npm(${ARG_FOLDER} ${name}@${version} ${archive_name} ${remedy})
        endif()
    endif()
    if(NOT EXISTS ${archive})
        message(FATAL_ERROR "${ARG_OPTION}: there is no ${archive}")
    endif()
    file(SHA512 ${archive} found)
    if(NOT found STREQUAL sha512)
        message(FATAL_ERROR "${archive} is not the package ${name} ${version}: its SHA-512 is "
                            "${found}, not ${sha512}. Remove it")
    endif()
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${ARG_FOLDER})
endfunction()

# fetch_charts(variable): sets it to the folder of plotly-cartesian.min.js and its LICENSE: plotly.js without maps and
# three dimensions, MIT licence. It draws the charts.
function(fetch_charts variable)
    set(folder ${PROJECT_BINARY_DIR}/charts)
    fetch_npm_package(plotly.js-cartesian-dist-min 4.1.1
        a3c1ab15ebac9dcc012316c1ca7449a58e29920541e9c68cf892e9c2b2d86dbb0eedd67c149f9254dd85afe2fb9221bf67ac383f93b426eb3f42be4479f1d57a
        OPTION TRICONTACT_CHARTS FOLDER ${folder})
    set(${variable} ${folder}/package PARENT_SCOPE)
endfunction()

# bundle_scene(variable entry): sets it to a script that is made of the module `entry` and of what it imports from three.js,
# MIT licence, which draws in three dimensions. esbuild leaves out of that what is not needed.
function(bundle_scene variable entry)
    set(folder ${PROJECT_BINARY_DIR}/scene)
    fetch_npm_package(three 0.187.0
        422bbb47e0a687c0acb59b18d6e24e4969d595fa3b66d34b57b985f0996d9372c1dc0b43bbd71166572744a90093c638cfa28ac37e73ed8ed4addee3598f1eb4
        OPTION TRICONTACT_SCENES FOLDER ${folder})
    find_program(TRICONTACT_ESBUILD esbuild DOC "Bundles the view in three dimensions")
    if(NOT TRICONTACT_ESBUILD)
        message(FATAL_ERROR "esbuild, which bundles the view in three dimensions, is not there: install the package esbuild")
    endif()
    # Where esbuild looks for three.
    file(MAKE_DIRECTORY ${folder}/node_modules)
    file(CREATE_LINK ${folder}/package ${folder}/node_modules/three SYMBOLIC)
    set(bundle ${folder}/scene.min.js)
    add_custom_command(OUTPUT ${bundle} DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${entry} VERBATIM
        COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${folder}/node_modules ${TRICONTACT_ESBUILD}
                ${CMAKE_CURRENT_SOURCE_DIR}/${entry} --bundle --minify --format=iife --target=es2020
                --legal-comments=inline --charset=ascii --log-level=error --outfile=${bundle})
    set(${variable} ${bundle} PARENT_SCOPE)
endfunction()
