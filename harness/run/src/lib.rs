//! Schedules cases over engines, judges outcomes, emits one stream of events.
