//! Projections of the event stream: terminal, JSON, JUnit, Markdown.
