#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/deformable/mesh/measures.h>
#include <pleura/nodes/lung/pleural_space.h>
#include <pleura/nodes/lung/time_steps.h>

namespace pleura {

namespace {

constexpr double kFreed = 2e-6;   // [m^3] of gas; with less the lung is drawn on the wall
constexpr float kHilum = 0.025f;  // [m] the hilum's radius

constexpr std::array<std::pair<std::string_view, Pneumothorax>, 4> kKinds = {
    {{"NONE", Pneumothorax::none},
     {"CLOSED", Pneumothorax::closed},
     {"OPEN", Pneumothorax::open},
     {"TENSION", Pneumothorax::tension}}};

std::optional<Pneumothorax> kindOf(std::string_view text) {
  for (const auto& [name, kind] : kKinds)
    if (name == text) return kind;
  return std::nullopt;
}

/// The mediastinal points around the middle of all of them: where bronchus and vessels come in.
std::vector<int> hilumOf(const TriangleMesh& lung, const std::vector<int>& part) {
  std::vector<int> mediastinal;
  Vec3f middle = Vec3f::Zero();
  for (std::size_t i = 0; i < std::min(part.size(), lung.points.size()); ++i) {
    if (part[i] != static_cast<int>(LungPart::Mediastinal)) continue;
    mediastinal.push_back(static_cast<int>(i));
    middle += lung.points[i];
  }
  if (mediastinal.empty())
    throw std::invalid_argument("part: a lung without mediastinal points has no hilum");
  const auto point = [&](int i) -> const Vec3f& { return lung.points[static_cast<std::size_t>(i)]; };
  middle /= static_cast<float>(mediastinal.size());
  const Vec3f centre = point(*std::min_element(mediastinal.begin(), mediastinal.end(), [&](int a, int b) {
    return (point(a) - middle).squaredNorm() < (point(b) - middle).squaredNorm();
  }));
  std::erase_if(mediastinal, [&](int i) { return (point(i) - centre).norm() > kHilum; });
  return mediastinal;
}

void declareLung(NodeType& type) {
  using enum Access;
  type.field<&PleuralSpace::contacts>("contacts", initializeOnly, {})
      .means("the LungContacts of the lung: what they leave room for is the cavity");
  type.field<&PleuralSpace::compliance>("compliance", initializeOnly,
                                        static_cast<float>(RestingLung().compliance))
      .positive(1)
      .means("of this lung at rest [m^3/Pa]; both have 0.2 L/cmH2O (Levitzky)");
  type.field<&PleuralSpace::restingRecoil>("restingRecoil", initializeOnly,
                                           static_cast<float>(RestingLung().recoil))
      .measuredIn(Unit::pressure)
      .positive(1e5)
      .means("transpulmonary pressure at rest; 5 cmH2O (Guyton)");
  type.field<&PleuralSpace::recoil>("recoil", initializeOnly, "SIGMOID")
      .means("volume over transpulmonary pressure: LINEAR or SIGMOID (Narusawa 2001)");
  type.field<&PleuralSpace::airwayResistance>("airwayResistance", initializeOnly,
                                              static_cast<float>(LungMechanics().airwayResistance))
      .positive(1e12)
      .means(
          "of this lung's bronchus [Pa s/m^3]; two side by side have 1.5 cmH2O s/L (DuBois 1956: 1.01-1.99)");
  type.field<&PleuralSpace::ambientPressure>("ambientPressure", inputOutput, 101325)
      .measuredIn(Unit::pressure)
      .within(1e3, 1e7)
      .means("at the mouth and at a wound; the pressures told are above it");
  type.field<&PleuralSpace::poissonRatio>("poissonRatio", initializeOnly, 0.3f)
      .within(0, 0.49995)
      .means("of the lung that gas has set free; Young's modulus follows from compliance");
  type.field<&PleuralSpace::elements>("elements", initializeOnly, 300)
      .within(1, 20000)
      .means("finite elements of the lung that gas has set free");
}

void declareGas(NodeType& type) {
  using enum Access;
  type.field<&PleuralSpace::pneumothorax>("pneumothorax", inputOutput, "NONE")
      .means(
          "NONE; CLOSED: gasVolume comes in and stays; OPEN: a wound both ways; TENSION: a valve, in only");
  type.field<&PleuralSpace::leakArea>("leakArea", inputOutput, 1e-5f)
      .measuredIn(Unit::area)
      .within(0, 1)
      .means("of the wound or tear");
  type.field<&PleuralSpace::leakSource>("leakSource", inputOutput, "WOUND")
      .means("where a tension pneumothorax has its gas from: WOUND or LUNG");
  type.field<&PleuralSpace::gasVolume>("gasVolume", inputOutput, 5e-4f)
      .measuredIn(Unit::volume)
      .within(0, 0.01)
      .means("that comes in when pneumothorax becomes CLOSED, at ambient pressure");
  type.field<&PleuralSpace::drain>("drain", inputOutput, false)
      .means("whether a tube draws gas out of the pleural space");
  type.field<&PleuralSpace::drainSuction>("drainSuction", inputOutput,
                                          static_cast<float>(PleuralDrain().suction))
      .measuredIn(Unit::pressure)
      .within(0, 1e5)
      .means("of the tube, below ambient");
  type.field<&PleuralSpace::drainResistance>("drainResistance", inputOutput,
                                             static_cast<float>(PleuralDrain().resistance))
      .within(1, 1e15)
      .means("of the tube [Pa s/m^3]");
  type.field<&PleuralSpace::keyPress>("keyPress", inputOnly, "").means("a key, from KeySensor.keyPress");
  type.field<&PleuralSpace::woundKeys>("woundKeys", inputOutput, "")
      .means("keys that open a wound and close it");
  type.field<&PleuralSpace::drainKeys>("drainKeys", inputOutput, "")
      .means("keys that turn the drain on and off");
}

void declareOutputs(NodeType& type) {
  using enum Access;
  type.field<&PleuralSpace::intrapleuralPressure>("intrapleuralPressure", outputOnly, 0)
      .measuredIn(Unit::pressure)
      .means("between lung and wall, above ambient");
  type.field<&PleuralSpace::alveolarPressure>("alveolarPressure", outputOnly, 0)
      .measuredIn(Unit::pressure)
      .means("in the lung, above ambient");
  type.field<&PleuralSpace::transpulmonaryPressure>("transpulmonaryPressure", outputOnly, 0)
      .measuredIn(Unit::pressure)
      .means("alveolar less intrapleural: what stretches the lung");
  type.field<&PleuralSpace::airFlow>("airFlow", outputOnly, 0)
      .measuredIn(Unit::volumeFlow)
      .means("into the lung");
  type.field<&PleuralSpace::lungVolume>("lungVolume", outputOnly, 0)
      .measuredIn(Unit::volume)
      .means("of the lung");
  type.field<&PleuralSpace::cavityVolume>("cavityVolume", outputOnly, 0)
      .measuredIn(Unit::volume)
      .means("of lung and pleural space together");
  type.field<&PleuralSpace::pleuralGas>("pleuralGas", outputOnly, 0)
      .measuredIn(Unit::volume)
      .means("gas in the pleural space");
  type.field<&PleuralSpace::label>("label", outputOnly, {})
      .means("the above as people read it, in cmH2O, mL and L/s; for Text.string");
  type.field<&PleuralSpace::index>("index", outputOnly, {})
      .means("the lung's points, all of them while gas has set it free, else none");
  type.field<&PleuralSpace::point>("point", outputOnly, {})
      .measuredIn(Unit::length)
      .means("where they are now, one for each of index");
}

}  // namespace

void PleuralSpace::declare(NodeType& type) {
  Node::declare(type);
  type.named("PleuralSpace", "Pleura")
      .means("the space between a lung and the cage: pressures, air flow and pneumothorax");
  declareLung(type);
  declareGas(type);
  declareOutputs(type);
}

void PleuralSpace::onInitialize() {
  auto* held = contacts.get();
  auto* organ = held != nullptr ? held->organ.get() : nullptr;
  if (organ == nullptr)
    return context().warn(*this, "contacts is missing: LungContacts with an organ are expected");
  for (Field* output : std::initializer_list<Field*>{&intrapleuralPressure, &alveolarPressure,
                                                     &transpulmonaryPressure, &airFlow, &lungVolume,
                                                     &cavityVolume, &pleuralGas, &label, &index, &point}) {
    context().time.routeNoEvent(*output, id);
    held->shape.routeNoEvent(*output, id);
  }
  keyPress.routeNoEvent(hearKey_, id);
  for (Field* input : std::initializer_list<Field*>{&pneumothorax, &leakArea, &leakSource, &gasVolume, &drain,
                                                    &drainSuction, &drainResistance, &ambientPressure})
    input->routeNoEvent(hearChange_);
  index.routeNoEvent(organ->contactIndex);
  point.routeNoEvent(organ->contactPoint);
}

void PleuralSpace::beginAt(Time time, double cavity) {
  freed_.reset();
  isRefused_ = false;
  try {
    begin(cavity);
    time_ = time;
  } catch (const std::invalid_argument& refused) {
    context().warn(*this, refused.what());
  }
}

void PleuralSpace::begin(double cavity) {
  auto& organ = *contacts.get()->organ.get();
  const RestingLung atRest{.volume = std::abs(signedVolume(organ.rest().points, organ.rest().triangles)),
                           .recoil = restingRecoil.getValue(id),
                           .compliance = compliance.getValue(id)};
  constexpr double kMostOfRest = 2.9 / 1.15;  // TLC over FRC of men (the sigmoid's default)
  step_.lung.recoil = recoil.getValue(id) == "LINEAR"
                          ? RecoilCurve::linear(atRest)
                          : RecoilCurve::sigmoid(atRest, 0, kMostOfRest * atRest.volume);
  step_.lung.airwayResistance = airwayResistance.getValue(id);
  state_ = restingState(step_.lung, ambientPressure.getValue());
  inputs_ = {};
  inputs_.ambientPressure = ambientPressure.getValue();
  inputs_.cavityVolume = cavity + step_.lung.filmVolume;
  advance(step_.lung, inputs_, kLongestStep, state_);
}

void PleuralSpace::takeInputs() {
  inputs_.ambientPressure = ambientPressure.getValue();
  inputs_.drain = {
      .isOn = drain.getValue(), .suction = drainSuction.getValue(), .resistance = drainResistance.getValue()};
  inputs_.leak.hole.area = leakArea.getValue();
  inputs_.leak.source = leakSource.getValue() == "LUNG" ? LeakSource::lung : LeakSource::wound;
  const auto kind = kindOf(pneumothorax.getValue());
  if (!kind)
    return context().warn(*this,
                          "pneumothorax is NONE, CLOSED, OPEN or TENSION, not " + pneumothorax.getValue());
  if (*kind == Pneumothorax::closed && inputs_.leak.kind != *kind)
    admitGas(gasVolume.getValue(), inputs_.ambientPressure, state_);
  inputs_.leak.kind = *kind;
}

void PleuralSpace::advanceTo(Time time, double cavity) {
  const double from = state_.cavityVolume, change = cavity + step_.lung.filmVolume - from;
  const TimeSteps steps = timeSteps(time - time_);
  const double dt = std::clamp(steps.length, kShortestStep, kLongestStep);
  for (int k = 1; k <= steps.count; ++k) {
    inputs_.cavityVolume = from + change * k / steps.count;
    const LungState before = state_;
    const PleuralReport report = advance(step_.lung, inputs_, dt, state_);
    if (!report.isAccepted || !report.hasConverged)
      return context().warn(*this, "the pressures can't be found for a cavity of that volume: they stay");
    step_.inputs = inputs_;
    step_.before = before;
    step_.duration = dt;
  }
}

const LungState& PleuralSpace::now() {
  auto* held = contacts.get();
  if (held == nullptr || held->organ.get() == nullptr) return state_;
  const auto& shape = held->shape.getValue();
  const TriangleMesh& rest = held->organ.get()->rest();
  if (shape.size() != rest.points.size() || shape.empty()) return state_;
  const Time time = context().time.getValue();
  const std::uint64_t stamp = held->organ.get()->origCoord.getStamp();
  const bool isNew = stamp != restStamp_;
  if (isNew || time > time_) {
    const double cavity = std::abs(signedVolume(shape, rest.triangles));
    if (isNew) {
      restStamp_ = stamp;
      beginAt(time, cavity);
    }
    if (time > time_) advanceTo(time, cavity);
  }
  time_ = time;
  takeInputs();
  return state_;
}

const PleuralSpace::Step& PleuralSpace::lastStep() {
  now();
  return step_;
}

void PleuralSpace::PleuralGas::update() {
  auto& node = *static_cast<PleuralSpace*>(getOwner());
  value = static_cast<float>(std::max(node.now().pleuralVolume() - node.step_.lung.filmVolume, 0.0));
}

void PleuralSpace::Label::update() {
  auto& node = *static_cast<PleuralSpace*>(getOwner());
  const LungState& now = node.now();
  const float gas = node.pleuralGas.getValue();
  value = {fmt::format("intrapleural {:+.1f} cmH2O", now.intrapleural / kCmH2O),
           fmt::format("alveolar {:+.1f} cmH2O", now.alveolar / kCmH2O),
           fmt::format("transpulmonary {:+.1f} cmH2O", now.transpulmonary / kCmH2O),
           fmt::format("lung {:.0f} mL", now.lungVolume / kLitre * 1000),
           fmt::format("air flow {:+.2f} L/s", now.airFlow / kLitre)};
  if (gas > kFreed) value.push_back(fmt::format("gas in the pleural space {:.0f} mL", gas / kLitre * 1000));
}

void PleuralSpace::onKey() {
  const std::string& key = keyPress.getValue(id);
  if (key.empty()) return;
  if (woundKeys.getValue().find(key) != std::string::npos)
    pneumothorax.setValue(pneumothorax.getValue() == "OPEN" ? "NONE" : "OPEN");
  if (drainKeys.getValue().find(key) != std::string::npos) drain.setValue(!drain.getValue());
}

bool PleuralSpace::isFree() {
  if (now().pleuralVolume() - step_.lung.filmVolume < kFreed || isRefused_) return false;
  if (freed_) return true;
  auto& held = *contacts.get();
  const TriangleMesh& rest = held.organ.get()->rest();
  try {
    freed_.emplace(rest, hilumOf(rest, held.part.getValue(held.id)),
                   FreedLungMaterial{.compliance = compliance.getValue(id),
                                     .poissonRatio = poissonRatio.getValue(id),
                                     .elements = elements.getValue(id)});
  } catch (const std::invalid_argument& refused) {
    isRefused_ = true;
    context().warn(*this, std::string(refused.what()) + ": the lung is drawn on the wall");
  }
  return freed_.has_value();
}

void PleuralSpace::evaluateIndex(std::vector<int>& out) {
  out.resize(isFree() ? contacts.get()->organ.get()->origCoord.size() : 0);
  std::iota(out.begin(), out.end(), 0);
}

void PleuralSpace::evaluatePoint(std::vector<Vec3f>& out) {
  if (!isFree()) return out.clear();
  const auto& cavity = contacts.get()->shape.getValue();
  out.resize(cavity.size());
  const FreedLungReport report = freed_->shape(state_.lungVolume, cavity, out);
  if (!report.hasConverged)
    context().warn(*this, "where the lung touches the wall was not settled: it is drawn as far as it was");
}

}  // namespace pleura
