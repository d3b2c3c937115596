#include <algorithm>
#include <fstream>
#include <map>
#include <memory>

#include <fmt/format.h>

#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/number_in.h>
#include <pleura/x3d/browser/commands/progress.h>
#include <pleura/x3d/browser/commands/scene_options.h>
#include <pleura/x3d/browser/scene/state_hash.h>
#include <pleura/x3d/browser/tradeoff/advice.h>
#include <pleura/x3d/browser/tradeoff/chart.h>
#include <pleura/x3d/browser/tradeoff/corrected_shapes.h>
#include <pleura/x3d/browser/tradeoff/shape_file.h>
#include <pleura/x3d/browser/tradeoff/tier_run.h>
#include <pleura/x3d/browser/view/offscreen_view.h>

namespace pleura {

namespace {

struct TradeoffOptions : SceneOptions {
  std::filesystem::path output;
  double seconds = 4;
  int moments = 4;
  int elements = 60;
};

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw Fault(file.string() + ": can't be written");
}

void drawChart(const std::vector<TierFigures>& figures, const std::filesystem::path& folder) {
  write(folder / "tradeoff.svg", chartAsSvg(figures));
  const auto scenePath = folder / "tradeoff.x3d";
  write(scenePath, chartAsScene(figures));
  Scene chart;
  chart.load(scenePath);
  chart.tick(0);
  constexpr int kWidth = 1200;
  OffscreenView view(chart, kWidth, static_cast<int>(kWidth * chartAspect(figures)));
  render::writePng(view.picture(), folder / "tradeoff.png");
}

using Shapes = std::vector<std::vector<Vec3f>>;

/// One scene's breath through all tiers.
class Comparison {
 public:
  Comparison(Scene& scene, const TradeoffOptions& options)
      : scene_(scene),
        options_(options),
        breaths_(recordBreath(scene, options.seconds, options.moments)),
        table_(options.output / "tradeoff.csv",
               fmt::format("{} for {} s, {} moments, {} elements, errors where nothing drives, corrected "
                           "reference, state {}",
                           options.file.filename().string(), options.seconds, options.moments,
                           options.elements, stateHash(scene))) {
    if (breaths_.empty())
      throw Fault(options.file.string() +
                  ": names no contacts of an organ (LungContacts, DiaphragmContacts)");
  }

  const FigureTable& run() {
    for (std::size_t k = 0; k < breaths_.size(); ++k) {
      const OrganBreath& breath = breaths_[k];
      const Shapes reference = referenceOf(breath, options_.output / fmt::format("reference_{}.bin", k));
      for (const auto& tier : deformationTiers(options_.elements)) measure(breath, tier, reference);
    }
    return table_;
  }

 private:
  TierRun runWithProgress(const OrganBreath& breath, const DeformationTier& tier) {
    Progress progress(fmt::format("{}, {}", breath.organ, tier.name()));
    return runTier(scene_, breath, tier, [&progress](double done) { progress.show(done); });
  }

  bool isMeasured(const OrganBreath& breath, const DeformationTier& tier) const {
    return table_.has(breath.organ, tier.method, tier.elements);
  }

  /// Kept in a file, since it takes longest. What it is made of is told with its error.
  Shapes referenceOf(const OrganBreath& breath, const std::filesystem::path& file) {
    const auto [nonlinear, linear, finer] = referenceTiers(options_.elements);
    if (isMeasured(breath, nonlinear) && isMeasured(breath, linear))
      if (auto kept = readShapes(file, breath.moments.size(), breath.rest.points.size())) return *kept;
    TierRun base = runWithProgress(breath, nonlinear);
    TierRun cheap = runWithProgress(breath, linear);
    Shapes reference = correctedShapes(base.shapes, runWithProgress(breath, finer).shapes, cheap.shapes);
    writeShapes(file, reference);
    tell(breath, base, reference);
    tell(breath, cheap, reference);
    return reference;
  }

  void measure(const OrganBreath& breath, const DeformationTier& tier, const Shapes& reference) {
    if (isMeasured(breath, tier)) return;
    TierRun run;
    try {
      run = runWithProgress(breath, tier);
    } catch (const std::invalid_argument& refused) {
      return fmt::print(stderr, "{}, {}: left out: {}\n", breath.organ, tier.name(), refused.what());
    }
    tell(breath, run, reference);
  }

  void tell(const OrganBreath& breath, TierRun& run, const Shapes& reference) {
    run.figures.error = shapeError(run.shapes, reference, breath.rest.triangles, breath.driven);
    for (const OrganBreath& other : breaths_) measureBeside(breath, other, run);
    const TierFigures& figures = run.figures;
    if (!table_.has(figures.organ, figures.method, figures.elements)) table_.add(figures);
  }

  /// Lungs are closed, the diaphragm lies beside them; what is not measured is as the scene has it.
  static void measureBeside(const OrganBreath& breath, const OrganBreath& other, TierRun& run) {
    const auto isLung = [](const OrganBreath& organ) { return organ.organ.starts_with("LUNG"); };
    if (isLung(breath) == isLung(other)) return;
    Shapes shown;
    for (const auto& moment : other.moments) shown.push_back(moment.shown);
    if (isLung(breath)) {
      measureContact({breath.rest, other.rest.points}, run.shapes, shown, run.figures.error);
    } else {
      measureContact({other.rest, breath.rest.points}, shown, run.shapes, run.figures.error);
    }
  }

  Scene& scene_;
  const TradeoffOptions& options_;
  std::vector<OrganBreath> breaths_;
  FigureTable table_;
};

/// For scenes that ask for a tolerance or a budget.
void keep(const std::filesystem::path& figures) {
  const auto kept = keptFigures();
  std::error_code problem;
  std::filesystem::create_directories(kept.parent_path(), problem);
  std::filesystem::copy_file(figures, kept, std::filesystem::copy_options::overwrite_existing, problem);
  if (problem) fmt::print(stderr, "{}: the figures can't be kept: {}\n", kept.string(), problem.message());
}

void compare(const TradeoffOptions& options) {
  std::filesystem::create_directories(options.output);
  const auto scene = options.load();
  for (const auto& assignment : options.playback.set) scene->set(assignment);
  Comparison comparison(*scene, options);
  const FigureTable& table = comparison.run();
  drawChart(table.all(), options.output);
  keep(options.output / "tradeoff.csv");
  const std::string text = advice(table.all());
  write(options.output / "advice.txt", text + "\n");
  fmt::print("{}\n{}: tradeoff.csv, tradeoff.svg, tradeoff.png, advice.txt\n", text, options.output.string());
}

}  // namespace

void addTradeoffCommand(CLI::App& app) {
  auto* command =
      app.add_subcommand("tradeoff", "Measure error against cost for every way to deform an organ");
  const auto options = std::make_shared<TradeoffOptions>();
  options->addTo(*command);
  command
      ->add_option("-o,--output", options->output,
                   "Folder for chart, table and advice; work that was interrupted goes on there")
      ->required();
  command->add_option("--for", options->seconds, "Seconds of a breath")->check(numberIn(1e-3, 1e3));
  command->add_option("--moments", options->moments, "Moments of the breath")->check(numberIn(1, 1000));
  command
      ->add_option("--elements", options->elements,
                   "Elements of the coarsest lattice; the reference has 64 times as many, corrected by 192")
      ->check(numberIn(8, 300));
  command->callback([options] { compare(*options); });
}

}  // namespace pleura
