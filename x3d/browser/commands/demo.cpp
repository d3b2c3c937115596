#include <algorithm>
#include <fstream>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <pleura/x3d/browser/commands/commands.h>
#include <pleura/x3d/browser/commands/picture_options.h>
#include <pleura/x3d/browser/commands/progress.h>
#include <pleura/x3d/browser/commands/scene_folder.h>
#include <pleura/x3d/browser/commands/scene_options.h>
#include <pleura/x3d/browser/render/film_writer.h>

namespace pleura {

namespace {

struct DemoOptions {
  PictureOptions picture;
  std::filesystem::path output = "out";
};

constexpr double kSeconds = 20;
constexpr double kFramesPerSecond = 30;
constexpr auto kPauses = "5:p 6.5:p";  // pause and resume
constexpr double kDeepFrom = 12;       // the first breath that starts after this is deep
constexpr double kDeepUntil = 16;
constexpr int kSheetPictures = 12;
constexpr int kSheetColumns = 4;

struct Sample {
  double time, volume, domeHeight, phase;
};

/// What a teacher would ask for, as one row a frame.
class BreathTable {
 public:
  BreathTable(Scene& scene, std::filesystem::path file) : scene_(scene), file_(std::move(file)), out_(file_) {
    if (!out_) throw FileError(file_.string() + ": can't be written");
    out_ << "time_s,lung_volume_L,dome_height_cm";
    for (int rib = 1; rib <= kRibs; ++rib) out_ << fmt::format(",rib_{0}_pump_deg,rib_{0}_bucket_deg", rib);
    out_ << ",force_N,depth_mm,touched\n";
  }

  void add(Time now) {
    samples_.push_back(
        {now, number("BREATH.lungVolume"), number("BREATH.domeHeight"), number("BREATH.phase")});
    fmt::print(out_, "{:.4f},{:.4f},{:.3f}", now, samples_.back().volume * 1e3,
               samples_.back().domeHeight * 1e2);
    const double inflation = number("BREATH.inflation");
    for (int rib = 1; rib <= kRibs; ++rib) {
      const Vec3f angles = static_cast<SFVec3f&>(scene_.field(fmt::format("RIB_L{}.angles", rib))).getValue();
      constexpr double kDegrees = 57.29577951308232;
      fmt::print(out_, ",{:.3f},{:.3f}", angles.x() * inflation * kDegrees,
                 angles.y() * inflation * kDegrees);
    }
    const float force = static_cast<SFVec3f&>(scene_.field("STYLUS.force")).getValue().norm();
    fmt::print(out_, ",{:.4f},{:.4f},{}\n", force, number("STYLUS.depth") * 1e3,
               static_cast<SFString&>(scene_.field("STYLUS.touched")).getValue());
    strongest_ = std::max(strongest_, force);
  }

  void close() {
    out_.close();
    if (!out_) throw FileError(file_.string() + ": can't be written");
  }

  const std::vector<Sample>& samples() const { return samples_; }
  /// [N] on the hand.
  double strongestForce() const { return strongest_; }

 private:
  static constexpr int kRibs = 12;

  double number(const char* path) { return static_cast<SFFloat&>(scene_.field(path)).getValue(); }

  Scene& scene_;
  std::filesystem::path file_;
  std::ofstream out_;
  std::vector<Sample> samples_;
  float strongest_ = 0;
};

/// Largest less smallest of what `get` picks, over the samples before `end`.
template <class Get>
double swing(const std::vector<Sample>& samples, double end, Get get) {
  double least = get(samples.front());
  double most = least;
  for (const auto& sample : samples) {
    if (sample.time > end) break;
    least = std::min(least, get(sample));
    most = std::max(most, get(sample));
  }
  return most - least;
}

double breathsPerMinute(const std::vector<Sample>& samples) {
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i].phase < samples[i - 1].phase) return 60 / samples[i].time;
  return 0;
}

void tell(const BreathTable& table, const TickStatistics& statistics, double drawing) {
  const auto& samples = table.samples();
  const auto volume = [](const Sample& s) { return s.volume; };
  const auto dome = [](const Sample& s) { return s.domeHeight; };
  fmt::print("breathing rate        {:6.1f} breaths per minute\n", breathsPerMinute(samples));
  fmt::print("tidal volume          {:6.0f} mL quiet, {:.2f} L in a breath to total lung capacity\n",
             swing(samples, kDeepFrom, volume) * 1e6, swing(samples, kSeconds, volume) * 1e3);
  fmt::print("dome excursion        {:6.1f} cm quiet, {:.1f} cm deep\n",
             swing(samples, kDeepFrom, dome) * 1e2, swing(samples, kSeconds, dome) * 1e2);
  fmt::print("touch                 {:6.2f} N at most on the hand, over left ribs 4 to 6 and the lung\n",
             table.strongestForce());
  fmt::print(
      "time per frame        {:6.2f} ms to breathe and to touch, {:.0f} ms to draw (software OpenGL)\n",
      statistics.quantile(0.5), drawing);
}

void runDemo(const DemoOptions& options) {
  std::filesystem::create_directories(options.output);
  SceneOptions sceneOptions;
  sceneOptions.file = sceneFolder() / "touch_thorax.x3d";
  sceneOptions.playback.step = 1 / kFramesPerSecond;
  sceneOptions.playback.keys = kPauses;
  const auto scene = sceneOptions.load();
  Playback playback(*scene, sceneOptions.playback);
  auto view = options.picture.view(*scene);
  BreathTable table(*scene, options.output / "breathing.csv");
  render::FilmWriter film(options.output / "breathing.mp4", options.picture.width(), options.picture.height(),
                          kFramesPerSecond);
  std::vector<render::Image> sheet;
  std::vector<double> drawing;
  Progress progress("breathing");
  const int frames = static_cast<int>(kSeconds * kFramesPerSecond);
  for (int frame = 0; frame <= frames; ++frame) {
    const double now = frame / kFramesPerSecond;
    if (now >= kDeepFrom) scene->set(now < kDeepUntil ? "BREATH.depth=1" : "BREATH.depth=0.142857");
    playback.runUntil(now, [&](Time time) { table.add(time); });
    const auto start = std::chrono::steady_clock::now();
    const auto picture = view->picture();
    drawing.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    film.write(picture);
    if (frame % (frames / kSheetPictures) == frames / kSheetPictures / 2) sheet.push_back(picture);
    progress.show(static_cast<double>(frame) / frames);
  }
  film.close();
  table.close();
  render::writePng(render::contactSheet(sheet, kSheetColumns), options.output / "breathing.png");
  std::nth_element(drawing.begin(), drawing.begin() + frames / 2, drawing.end());
  tell(table, playback.statistics(), drawing[static_cast<std::size_t>(frames / 2)]);
  fmt::print("written               {0}/breathing.mp4, {0}/breathing.png, {0}/breathing.csv\n",
             options.output.string());
  if (scene->diagnostics().errors() > 0) throw Fault("");
}

}  // namespace

void addDemoCommand(CLI::App& app) {
  auto* command = app.add_subcommand(
      "demo",
      "Twenty seconds of the default thorax, breathing and touched: a film, a contact sheet, a table");
  const auto options = std::make_shared<DemoOptions>();
  options->picture.size = "960x720";
  options->picture.addTo(*command);
  command->add_option("-o,--output", options->output, "Folder for the results")->capture_default_str();
  command->callback([options] { runDemo(*options); });
}

}  // namespace pleura
