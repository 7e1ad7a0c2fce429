//! One self-contained HTML page that shows a scene and its path; it opens offline.

