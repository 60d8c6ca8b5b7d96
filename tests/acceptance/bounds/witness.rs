//! A witness that is wrong stays wrong: it costs sharpness and never truth.
