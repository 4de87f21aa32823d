#pragma once

#include "formats/case/case_file.h"

#include <Eigen/Core>

#include <string>

namespace morph::test {

/// The text of a case file that read_case_file() reads back as @p file, with absolute paths.
std::string case_text(const CaseFile& file);

/// Case file that morph-fit makes for markers of a mesh, as read.
CaseFile fitted_case(const std::string& mesh, const std::vector<std::string>& markers, int points = 12);

/// Displace every control point so that the curves turn by @p degrees about @p centre.
void turn(CaseFile& file, double degrees, const Eigen::Vector2d& centre);

/// Displace every control point by @p shift.
void shift(CaseFile& file, const Eigen::Vector2d& shift);

} // namespace morph::test
