#pragma once
/// Settings of controllers as their own files have them.

namespace toolpace::testing {

inline constexpr const char* kGrbl =
    "$1=25\n$11=0.01\n$12=0.002\n$100=80\n$101=80\n$102=400\n$110=6000\n$111=6000\n$112=600\n$120=500\n$121=500\n$122="
    "50\n";
inline constexpr const char* kKlipper =
    "[printer]\nkinematics: cartesian\nmax_velocity: 100\nmax_accel: 1000\nmax_z_velocity: 10\nmax_z_accel: 100\n"
    "minimum_cruise_ratio: 0\n[gcode_arcs]\n";
inline constexpr const char* kLinuxcnc =
    "[TASK]\nCYCLE_TIME = 0.001\n[TRAJ]\nLINEAR_UNITS = mm\nMAX_LINEAR_VELOCITY = 200\nMAX_LINEAR_ACCELERATION = 1\n"
    "[AXIS_X]\nMAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\n[AXIS_Y]\nMAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\n"
    "[AXIS_Z]\nMAX_VELOCITY = 50\nMAX_ACCELERATION = 500\n";
inline constexpr const char* kMarlin =
    "echo: M92 X80 Y80 Z400\necho: M203 X100 Y100 Z10\necho: M201 X1000 Y1000 Z100\necho: M204 P1000 R1000 T1000\n"
    "echo: M205 S0 T0 J0.02\n";

}  // namespace toolpace::testing
