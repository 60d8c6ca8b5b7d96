//! The acceptance suite: one test binary, one room for each subject.

mod scenes;
mod support;

mod body;
mod certificate;
mod command_line;
mod methods;
mod paper;
mod practice;
mod proof;
mod repository;
mod robustness;
mod scene_pages;
mod solvers;
mod sweep;
mod theory;
