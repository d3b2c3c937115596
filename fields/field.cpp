#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <pleura/fields/errors.h>
#include <pleura/fields/field.h>
#include <pleura/fields/propagation.h>

namespace pleura {

namespace {

bool contains(const std::vector<Field*>& fields, const Field* field) {
  return std::find(fields.begin(), fields.end(), field) != fields.end();
}

void remove(std::vector<Field*>& fields, const Field* field) {
  const auto found = std::find(fields.begin(), fields.end(), field);
  if (found != fields.end()) fields.erase(found);
}

}  // namespace

Field::~Field() {
  while (!routes_out.empty()) unroute(*routes_out.back());
  while (!routes_in.empty()) routes_in.back()->unroute(*this);
  if (queued_) Propagation::forget(this);
}

std::string_view Field::getName() const {
  return declaration_ != nullptr ? std::string_view(declaration_->name) : std::string_view();
}

std::string Field::getFullName() const {
  const std::string own = declaration_ != nullptr ? declaration_->name : std::string(getTypeName());
  return owner_ != nullptr ? owner_->describe() + "." + own : own;
}

void Field::attach(FieldOwner* owner, const FieldDeclaration* declaration) {
  owner_ = owner;
  declaration_ = declaration;
  access_ = declaration->access;
}

void Field::refuseSet() const {
  throw FieldAccessError(getFullName() + " is " + std::string(name(access_)) + ": it can't be set");
}

void Field::refuseGet() const {
  throw FieldAccessError(getFullName() + " is " + std::string(name(access_)) + ": it can't be read");
}

void Field::refuseRange() const {
  const auto& d = *declaration_;
  if (!std::isfinite(d.maximum)) throw FieldParseError(fmt::format("at least {}", d.minimum), 0);
  if (!std::isfinite(d.minimum)) throw FieldParseError(fmt::format("at most {}", d.maximum), 0);
  throw FieldParseError(fmt::format("{} to {}", d.minimum, d.maximum), 0);
}

bool Field::acceptsInput(const Field& from, std::size_t, std::string& why) const {
  if (from.getType() == getType()) return true;
  why = std::string(getTypeName());
  return false;
}

void Field::routeNoEvent(Field& to, NodeId id) {
  const std::string route = getFullName() + " TO " + to.getFullName();
  if (!canGet(access_) && id != owner_)
    throw RouteError("route " + route + ": " + getFullName() + " is inputOnly, it sends no events");
  if (to.owner_ != nullptr && id != to.owner_ && to.access_ != Access::inputOnly &&
      to.access_ != Access::inputOutput)
    throw RouteError("route " + route + ": " + to.getFullName() + " is " + std::string(name(to.access_)) +
                     ", it takes no events");
  if (routesTo(to)) return;
  std::string expected;
  if (!to.acceptsInput(*this, to.routes_in.size(), expected))
    throw RouteError("route " + route + ": " + std::string(getTypeName()) + " sent where " + expected +
                     " is expected");
  to.routes_in.reserve(to.routes_in.size() + 1);
  routes_out.push_back(&to);
  to.routes_in.push_back(this);
  unsettle(this);
}

void Field::route(Field& to, NodeId id) {
  if (routesTo(to)) return;
  routeNoEvent(to, id);
  Propagation::start(*this, &to);
}

void Field::unroute(Field& to) {
  remove(routes_out, &to);
  remove(to.routes_in, this);
  if (to.event.sender == this) to.event.sender = nullptr;
}

bool Field::routesTo(const Field& to) const {
  return routes_out.size() < to.routes_in.size() ? contains(routes_out, &to) : contains(to.routes_in, this);
}

void Field::touch() {
  if (event.sender != nullptr) {
    unsettle(event.sender);
    event.sender = nullptr;
  }
  Propagation::start(*this);
}

}  // namespace pleura
