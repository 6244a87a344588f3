// SPDX-License-Identifier: MIT
// Definitions of spectator.hpp.
#include <trophic/pictures/watch/exchange.hpp>
#include <trophic/pictures/watch/spectator.hpp>

namespace trophic::watch {

bool Spectator::is_heard() const {
  return exchange_ != nullptr && exchange_->is_open();
}

double Spectator::frame_hz() const {
  return is_heard() ? watched_hz : 0.0;
}

void Spectator::on_start(const observe::RunDescription& run, const View& view) {
  if (is_heard()) exchange_->with_footage([&](LiveFootage& footage) { footage.start(run, view); });
}

void Spectator::on_frame(const observe::Frame& frame) {
  if (is_heard()) exchange_->with_footage([&](LiveFootage& footage) { footage.add_frame(frame); });
}

void Spectator::on_event(const observe::Event& event, const View& view) {
  if (!is_heard()) return;
  if (event.kind == observe::EventKind::capture) {
    return exchange_->with_footage([&](LiveFootage& footage) { footage.add_catch(catch_of(event, view)); });
  }
  if (event.kind != observe::EventKind::death) return;
  const bool is_catch = event.cause == Cause::caught;
  exchange_->with_footage([&](LiveFootage& footage) { footage.add_death(view, event.body, is_catch); });
}

void Spectator::on_tick(const View& view) {
  if (!is_heard()) return;
  exchange_->with_footage([&](LiveFootage& footage) { footage.add_tick(view); });
  exchange_->wait_until_wanted();
}

}  // namespace trophic::watch
