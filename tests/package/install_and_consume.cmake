function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "failed (${code}): ${ARGN}\n${output}")
  endif()
endfunction()

# The command has to exit with 2 and say `part`.
function(refuse part)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 2 OR NOT output MATCHES "${part}")
    message(FATAL_ERROR "not refused with '${part}' (${code}): ${ARGN}\n${output}")
  endif()
endfunction()

function(same_file a b)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${a} ${b} RESULT_VARIABLE differ)
  if(differ)
    message(FATAL_ERROR "${a} and ${b} differ")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${SCRATCH}/build -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix
    -DCMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/prefix/bin/foamsim scenes)

# The Python package, where it was built.
file(GLOB package ${SCRATCH}/prefix/lib/python3*/dist-packages)
if(package)
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${package} /usr/bin/python3 -B -c
      "import foamsim; foamsim.Simulation('doublebubble', n=8).step()")
endif()

# Its own names, from a scene file and the command line.
set(consumer ${SCRATCH}/build/consumer)
set(scene ${SOURCE}/pebble.toml)
run(${consumer} run ${scene} --steps 12 --quiet --out ${SCRATCH}/whole)
run(${consumer} run ${scene} --steps 12 --set wind=0.4 --quiet --out ${SCRATCH}/gale)
refuse("belongs to the effect 'wind'" ${consumer} run sphere --set wind=1 --out ${SCRATCH}/no)
refuse("belongs to the scene 'pebble'" ${consumer} run sphere --set pebble=1 --out ${SCRATCH}/no)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${SCRATCH}/whole/frames/frame_000012.ply
                        ${SCRATCH}/gale/frames/frame_000012.ply RESULT_VARIABLE differ)
if(NOT differ)
  message(FATAL_ERROR "the effect's option changes nothing")
endif()
file(STRINGS ${SCRATCH}/whole/vtp/frame_000012.vtp dye REGEX "Name=\"dye\"")
if(NOT dye)
  message(FATAL_ERROR "the effect's attribute is not written to .vtp")
endif()

# A run taken up again goes on with the effect's state and attribute, to the bit.
run(${consumer} run ${scene} --steps 5 --quiet --out ${SCRATCH}/parts)
run(${consumer} run --resume ${SCRATCH}/parts/checkpoint.cbor --steps 12 --quiet)
foreach(frame frames/frame_000012.ply vtp/frame_000012.vtp)
  same_file(${SCRATCH}/whole/${frame} ${SCRATCH}/parts/${frame})
endforeach()
refuse("pebble" ${SCRATCH}/prefix/bin/foamsim run --resume ${SCRATCH}/parts/checkpoint.cbor --steps 13)

# The examples build and run against the installed library as well.
foreach(example scene effect)
  run(${CMAKE_COMMAND} -S ${EXAMPLES}/${example} -B ${SCRATCH}/${example} -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix
      -DCMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}")
  run(${CMAKE_COMMAND} --build ${SCRATCH}/${example})
endforeach()
run(${SCRATCH}/scene/chain run chain --set bubbles=3 --steps 5 --quiet --out ${SCRATCH}/chain)
run(${SCRATCH}/effect/drain run doublebubble --set effects+=drain --steps 5 --quiet --out ${SCRATCH}/drain)
run(python3 ${EXAMPLES}/analysis/energy.py ${SCRATCH}/drain)
file(REMOVE_RECURSE ${SCRATCH})
