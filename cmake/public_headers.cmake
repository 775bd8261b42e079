# The face of the library: what a program that uses it includes. Everything else is private to the rooms; of it only what these
# headers themselves include is installed beside them.
set(TOOLPACE_PUBLIC_HEADERS
    nc/reader.h               # text -> Reading
    machine/read_machine.h    # machine file -> Setup
    pipeline/job.h            # Job -> Outcome
    pipeline/replan.h         # Outcome + another job -> Outcome
    pipeline/prove.h          # Outcome -> whether its setpoints keep every limit
    bound/lower_bound.h       # Outcome -> a time that no plan of its job beats
    sample/motion.h           # Outcome -> where it is at any time
    sample/sampler.h          # Outcome -> setpoints
    sample/program_pulses.h   # Outcome -> step pulses
    io/setpoint_writer.h      # setpoints -> file
    verify/verify.h           # file -> report
    report/report_page.h      # Outcome -> page
    tune/sweep.h              # job -> plans over look-ahead
    law/single_move.h)        # one move of one law

# Sets `out` to these headers and all that they include, relative to core/toolpace.
function(toolpace_needed_headers out)
  set(todo ${TOOLPACE_PUBLIC_HEADERS})
  set(needed "")
  while(todo)
    list(POP_FRONT todo header)
    if(header IN_LIST needed)
      continue()
    endif()
    list(APPEND needed ${header})
    set(file ${PROJECT_SOURCE_DIR}/core/toolpace/${header})
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} includes REGEX "^#include \"toolpace/")
    foreach(line IN LISTS includes)
      string(REGEX REPLACE "^#include \"toolpace/([^\"]+)\".*" "\\1" name "${line}")
      list(APPEND todo ${name})
    endforeach()
  endwhile()
  set(${out} ${needed} PARENT_SCOPE)
endfunction()
