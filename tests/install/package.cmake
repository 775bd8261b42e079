# cmake -P: makes the Debian packages of BUILD_DIR in SCRATCH, installs them below a root of their own, runs what they brought,
# and removes them again.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${SCRATCH})
run(cpack -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip --config ${BUILD_DIR}/CPackConfig.cmake -B ${SCRATCH})
file(GLOB packages ${SCRATCH}/*.deb)
file(GLOB package ${SCRATCH}/toolpace_${VERSION}_*.deb)
run(${DPKG_DEB} --field "${package}" Depends)
if(NOT output MATCHES "libc6")
  message(FATAL_ERROR "the package does not say what it needs: ${output}")
endif()
run(${CMAKE_CURRENT_LIST_DIR}/try_packages.sh ${packages})
message(STATUS "${output}")
