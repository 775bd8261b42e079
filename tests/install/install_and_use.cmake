# cmake -P: installs BUILD_DIR below SCRATCH, builds CONSUMER against the result and runs what was built.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${SCRATCH}/prefix)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${CXX}
    -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix -D TOOLPACE_VERSION_WANTED=${VERSION})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${CMAKE_COMMAND} -E chdir ${SCRATCH} ${SCRATCH}/build/consumer)
message(STATUS "the consumer says: ${output}")
if(EXISTS ${SCRATCH}/prefix/include/toolpace/plan/plan.h)
  message(FATAL_ERROR "plan/plan.h is private, and it was installed")
endif()
run(${SCRATCH}/prefix/bin/toolpace --version)
if(NOT output MATCHES "toolpace ${VERSION}")
  message(FATAL_ERROR "the installed toolpace calls itself: ${output}")
endif()
