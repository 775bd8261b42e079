#pragma once
/// What a job's options mean to the stages, and which stages two jobs share.

#include "toolpace/limits/limit_speed.h"
#include "toolpace/pipeline/job.h"

namespace toolpace {

/// Does the motion leave the path, within the tolerance tube?
bool is_through_tube(const Job& job);

/// Is any of its program about the tool's tip?
bool is_about_tip(const Job& job);

/// Are the corners of all blocks in continuous path mode rounded on the path?
bool blends_everywhere(const Job& job);

/// How the job treats corners where its program says nothing.
Rounding rounding(const CornerOptions& corner);

/// What is commanded on a path of the job.
Commands command(const Path& path, const Job& job);

/// The number of blocks of a program that move.
std::size_t motion_blocks(const Moves& moves);

/// Whether the look-ahead is as deep as the program is long, in blocks that move.
bool sees_all(const Job& job);

/// Whether corners that the job would pass with a step of the speed become stops: shaped, a step has echoes, each of them a step that
/// is too much for the axes.
bool stops_at_steps(const PlanOptions& options);

/// The job, or a copy as it is planned: looking at all blocks where its look-ahead is as deep as the program is long, and stopping at
/// corners where stops_at_steps().
std::shared_ptr<const Job> as_planned(std::shared_ptr<const Job> job);

/// How long the path takes where every segment is run as fast as it is commanded [s].
double time_at_feeds(const Path& path, const Commands& commands);

/// The part of the options that caps speeds.
LimitOptions limit_options(const PlanOptions& options);

/// Whether all that decides where the machine goes, however fast, is the same.
bool has_same_route(const Job& a, const Job& b);

/// Whether all that limit_speed() looks at besides the path is the same.
bool has_same_limits(const Job& a, const Job& b);

}  // namespace toolpace
