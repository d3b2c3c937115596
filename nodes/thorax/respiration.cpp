#include <algorithm>
#include <cmath>

#include <pleura/nodes/core/scene_context.h>
#include <pleura/nodes/thorax/respiration.h>

namespace pleura {

void Respiration::declare(NodeType& type) {
  Node::declare(type);
  type.named("Respiration", "Pleura")
      .means("the breath: rate, depth, pattern and pause; drives ribs and diaphragm");
  using enum Access;
  type.field<&Respiration::rate>("rate", inputOutput, 15.f)
      .measuredIn(Unit::perMinute)
      .within(0, 120)
      .means("breaths a minute; adults at rest take 12 to 20");
  type.field<&Respiration::depth>("depth", inputOutput, 1.f / 7)
      .within(0, 1)
      .means("how far each breath goes from FRC (0) to TLC (1); quiet is about a seventh (Boron 2017)");
  type.field<&Respiration::style>("style", inputOutput, "ONE_TO_TWO")
      .means("SINUSOID, or ONE_TO_TWO: expiration twice as long as inspiration");
  type.field<&Respiration::paused>("paused", inputOutput, false).means("the breath stands still where it is");
  type.field<&Respiration::pauseKeys>("pauseKeys", inputOutput, "pP").means("keys that pause and resume");
  type.field<&Respiration::keyPress>("keyPress", inputOnly, "").means("a key, from KeySensor.keyPress");
  type.field<&Respiration::organVolume>("organVolume", inputOnly, 0)
      .measuredIn(Unit::volume)
      .means("the volumes of the lungs, a route from each");
  type.field<&Respiration::diaphragmTop>("diaphragmTop", inputOnly, 0)
      .measuredIn(Unit::length)
      .means("height of the diaphragm's highest point");
  type.field<&Respiration::phase>("phase", outputOnly, 0)
      .within(0, 1)
      .means("where in the breath, from its start");
  type.field<&Respiration::inflation>("inflation", outputOnly, 0).means("0 at FRC, 1 at TLC");
  type.field<&Respiration::lungVolume>("lungVolume", outputOnly, 0)
      .measuredIn(Unit::volume)
      .means("sum of the lungs' volumes");
  type.field<&Respiration::tidalVolume>("tidalVolume", outputOnly, 0)
      .measuredIn(Unit::volume)
      .means("swing of lungVolume over the last breath, as seen by who reads it every tick");
  type.field<&Respiration::domeHeight>("domeHeight", outputOnly, 0)
      .measuredIn(Unit::length)
      .means("height of the dome's top in the subject's frame");
}

void Respiration::onInitialize() {
  anchorTime_ = context().time.getValue();
  takeDepthAndStyle();
  anchor();
  context().time.routeNoEvent(hearTime_);
  keyPress.routeNoEvent(hearKey_, id);
  for (Field* field : {static_cast<Field*>(&rate), static_cast<Field*>(&paused), static_cast<Field*>(&depth)})
    field->routeNoEvent(hearChange_);
  style.routeNoEvent(hearChange_);
  organVolume.routeNoEvent(lungVolume, id);
  diaphragmTop.routeNoEvent(domeHeight, id);
  inflation.routeNoEvent(tidalVolume, id);
}

double Respiration::breathsAt(Time t) const { return anchorBreaths_ + anchorRate_ * (t - anchorTime_) / 60; }

void Respiration::anchor() {
  const Time now = context().time.getValue();
  anchorBreaths_ = breathsAt(now);
  anchorTime_ = now;
  anchorRate_ =
      paused.getValue() || !std::isfinite(rate.getValue()) ? 0 : std::clamp(rate.getValue(), 0.f, 120.f);
}

void Respiration::takeDepthAndStyle() {
  if (const float asked = depth.getValue(); std::isfinite(asked)) activeDepth_ = std::clamp(asked, 0.f, 1.f);
  if (const auto known = breathingPattern(style.getValue())) {
    activePattern_ = *known;
  } else {
    context().warn(*this, "style is SINUSOID or ONE_TO_TWO, not " + style.getValue());
  }
}

void Respiration::onTime() {
  const double breaths = breathsAt(context().time.getValue());
  if (std::floor(breaths) != std::floor(breaths_)) takeDepthAndStyle();
  publish(breaths);
}

void Respiration::onChange() {
  anchor();
  if (breaths_ == std::floor(breaths_)) takeDepthAndStyle();
}

void Respiration::onKey() {
  const std::string& key = keyPress.getValue(id);
  if (!key.empty() && pauseKeys.getValue().find(key) != std::string::npos)
    paused.setValue(!paused.getValue());
}

void Respiration::publish(double breaths) {
  const bool isFirst = !inflation.getStamp();
  if (breaths == breaths_ && !isFirst) return;
  breaths_ = breaths;
  const double inBreath = breaths - std::floor(breaths);
  phase.setValue(static_cast<float>(inBreath), id);
  inflation.setValue(static_cast<float>(activeDepth_ * excursion(activePattern_, inBreath)), id);
}

void Respiration::Sum::update() {
  double sum = 0;
  for (Field* input : routes_in) sum += static_cast<SFFloat*>(input)->getValue();
  value = static_cast<float>(sum);
}

void Respiration::Swing::update() {
  auto& node = static_cast<Respiration&>(*getOwner());
  const float volume = node.lungVolume.getValue();
  const double breath = std::floor(node.breaths_);
  if (breath != breath_) {
    wholeBreath_ = breath_ < 0 ? 0 : most_ - least_;
    least_ = most_ = volume;
    breath_ = breath;
  }
  least_ = std::min(least_, volume);
  most_ = std::max(most_, volume);
  value = wholeBreath_ > 0 ? wholeBreath_ : most_ - least_;
}

}  // namespace pleura
