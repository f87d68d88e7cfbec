// Printed formulas with the Lambert W of the crate lambert_w. FUNCTIONS is put in place of the line that says so.
#![allow(non_snake_case, unused_parens, dead_code)]

const M_E: f64 = std::f64::consts::E;
const M_PI_2: f64 = std::f64::consts::FRAC_PI_2;
const M_SQRT2: f64 = std::f64::consts::SQRT_2;

#[inline(always)]
fn W0(x: f64) -> f64 { lambert_w::lambert_w0(x) }
#[inline(always)]
fn Wm1(x: f64) -> f64 { lambert_w::lambert_wm1(x) }
#[inline(always)]
fn asin(x: f64) -> f64 { x.asin() }
#[inline(always)]
fn atan(x: f64) -> f64 { x.atan() }
#[inline(always)]
fn cos(x: f64) -> f64 { x.cos() }
#[inline(always)]
fn exp(x: f64) -> f64 { x.exp() }
#[inline(always)]
fn fabs(x: f64) -> f64 { x.abs() }
#[inline(always)]
fn pow(x: f64, y: f64) -> f64 { x.powf(y) }
#[inline(always)]
fn sin(x: f64) -> f64 { x.sin() }
#[inline(always)]
fn sqrt(x: f64) -> f64 { x.sqrt() }
#[inline(always)]
fn tan(x: f64) -> f64 { x.tan() }

/* FUNCTIONS */
