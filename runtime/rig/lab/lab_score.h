#pragma once
#include <functional>
#include <string>
#include <vector>

#include "rig/lab/lab_sample.h"

namespace mirada::rig {

/// What a group of samples comes to. Errors are of `blocked` answers to obstacles within the limits whose
/// foot is in the picture, relative to the truth. Shares are 0..1; NaN where nothing was counted.
struct LabScore {
  std::string name;
  int obstacles = 0;  ///< bearings with an obstacle within the limits
  int free = 0;       ///< bearings with none
  int errors = 0;     ///< answers that the error figures are made of
  double median_error = 0;
  double p90_error = 0;
  double bias = 0;          ///< median of the signed error
  double bias_to_1m = 0;    ///< the same of obstacles within 1 m
  double missed = 0;        ///< of `obstacles`: reported clear (or blocked far behind)
  double imagined = 0;      ///< of all answered: blocked well before the way ends
  double not_seen = 0;      ///< of all
  double within_95 = 0;     ///< of the errors: truth inside distance +- 1.96 sigma
  double paper_median = 0;  ///< the paper's geometry on the same boundaries
  double paper_bias = 0;
};

LabScore score(const std::string& name, const std::vector<const LabSample*>& samples,
               const LabLimits& limits = {});

/// A table: one score a group, and all samples under "all".
struct LabTable {
  std::string title;
  std::vector<LabScore> rows;
};

/// By distance, bearing, floor and light; the first table holds the score of all.
std::vector<LabTable> score_tables(const std::vector<LabSample>& samples, const LabLimits& limits = {});

/// The `most` pictures with the most bearings missed or imagined, worst first; fewer when fewer have any.
LabTable worst_pictures(const std::vector<LabSample>& samples, std::size_t most,
                        const LabLimits& limits = {});

}  // namespace mirada::rig
