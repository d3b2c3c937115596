#include <pleura/fields/errors.h>
#include <pleura/fields/field.h>
#include <pleura/fields/propagation.h>
#include <pleura/fields/range_text.h>

namespace pleura {

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

void Field::refuseRange(std::size_t at) const { throw FieldParseError(rangeText(*declaration_), at); }

bool Field::acceptsInput(const Field& from, std::size_t, std::string& why) const {
  if (from.getType() == getType()) return true;
  why = std::string(getTypeName());
  return false;
}

void Field::refuseRoute(const Field& to, const std::string& why) const {
  throw RouteError("route " + getFullName() + " TO " + to.getFullName() + ": " + why);
}

void Field::routeNoEvent(Field& to, NodeId id) {
  if (!canGet(access_) && id != owner_) refuseRoute(to, getFullName() + " is inputOnly, it sends no events");
  if (to.owner_ != nullptr && id != to.owner_ && to.access_ != Access::inputOnly &&
      to.access_ != Access::inputOutput)
    refuseRoute(to, to.getFullName() + " is " + std::string(name(to.access_)) + ", it takes no events");
  if (routesTo(to)) return;
  std::string expected;
  if (!to.acceptsInput(*this, to.routes_in.size(), expected))
    refuseRoute(to, std::string(getTypeName()) + " sent where " + expected + " is expected");
  routes_out.push_back(&to);
  try {
    to.routes_in.push_back(this);
  } catch (...) {
    routes_out.pop_back();
    throw;
  }
  to.inputsChanged_ = true;
  unsettle(this);
}

void Field::route(Field& to, NodeId id) {
  if (routesTo(to)) return;
  routeNoEvent(to, id);
  Propagation::start(*this, &to);
}

void Field::unroute(Field& to) {
  routes_out.remove(&to);
  to.routes_in.remove(this);
  to.inputsChanged_ = true;
  if (to.observes_) to.forgetEvents(this, to.event.stamp);
  if (to.event.sender == this) to.event.sender = nullptr;
}

bool Field::routesTo(const Field& to) const {
  return routes_out.size() < to.routes_in.size() ? routes_out.contains(&to) : to.routes_in.contains(this);
}

void Field::touch() {
  if (event.sender != nullptr) {
    unsettle(event.sender);
    event.sender = nullptr;
  }
  if (observes_) forgetEvents(nullptr, event.stamp);
  Propagation::start(*this);
}

}  // namespace pleura
