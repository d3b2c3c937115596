#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include <pleura/x3d/browser/tradeoff/deformation_tier.h>
#include <pleura/x3d/browser/tradeoff/tier_figures.h>

namespace pleura {

namespace {

constexpr auto kHeader =
    "organ,method,elements,median_ms,p99_ms,setup_ms,memory_MB,converged,rms_mm,p95_mm,max_mm,volume_percent,"
    "gap_mm,penetration_mm";

std::string lineOf(const TierFigures& f) {
  return fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{:.4g},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}",
                     f.organ, f.method, f.elements, 1e3 * f.median, 1e3 * f.p99, 1e3 * f.setUp,
                     f.memory / 1e6, f.converged ? 1 : 0, 1e3 * f.error.rms, 1e3 * f.error.percentile95,
                     1e3 * f.error.most, 100 * f.error.volume, 1e3 * f.error.gap, 1e3 * f.error.penetration);
}

/// False for a line that was cut off.
bool read(const std::string& line, TierFigures& f) {
  std::istringstream in(line);
  std::string numbers;
  if (!std::getline(in, f.organ, ',') || !std::getline(in, f.method, ',') || !std::getline(in, numbers))
    return false;
  std::replace(numbers.begin(), numbers.end(), ',', ' ');
  std::istringstream rest(numbers);
  ShapeError& e = f.error;
  if (!(rest >> f.elements >> f.median >> f.p99 >> f.setUp >> f.memory >> f.converged >> e.rms >>
        e.percentile95 >> e.most >> e.volume >> e.gap >> e.penetration))
    return false;
  for (double* ms : {&f.median, &f.p99, &f.setUp, &e.rms, &e.percentile95, &e.most, &e.gap, &e.penetration})
    *ms /= 1e3;
  f.memory *= 1e6;
  e.volume /= 100;
  return true;
}

}  // namespace

bool TierFigures::isChoosable() const { return converged && method != kReferenceMethod; }

std::filesystem::path keptFigures() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
    return std::filesystem::path(cache) / "pleura/tradeoff.csv";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return std::filesystem::path(home) / ".cache/pleura/tradeoff.csv";
  return {};
}

std::vector<TierFigures> readFigures(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<TierFigures> all;
  TierFigures figures;
  for (std::string line; std::getline(in, line);)
    if (read(line, figures)) all.push_back(figures);
  return all;
}

FigureTable::FigureTable(std::filesystem::path file, const std::string& key) : file_(std::move(file)) {
  const std::string begin = "# " + key + "\n" + kHeader + "\n";
  std::string first;
  if (std::ifstream in(file_); std::getline(in, first) && first == "# " + key) all_ = readFigures(file_);
  std::ofstream out(file_, std::ios::trunc);
  out << begin;
  for (const TierFigures& figures : all_) out << lineOf(figures) << '\n';
  if (!out.flush()) throw std::runtime_error(file_.string() + ": can't be written");
}

bool FigureTable::has(const std::string& organ, const std::string& method, int elements) const {
  return std::any_of(all_.begin(), all_.end(), [&](const TierFigures& f) {
    return f.organ == organ && f.method == method && f.elements == elements;
  });
}

void FigureTable::add(const TierFigures& figures) {
  all_.push_back(figures);
  std::ofstream out(file_, std::ios::app);
  out << lineOf(figures) << '\n';
  if (!out.flush()) throw std::runtime_error(file_.string() + ": can't be written");
}

}  // namespace pleura
