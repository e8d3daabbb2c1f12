#[inline(always)]
#[allow(non_snake_case, clippy::unused_unit, clippy::collapsible_else_if, clippy::needless_late_init, clippy::neg_multiply, unused_variables, unused_parens)]
pub fn acceleration<T0, T1, T2, T3, T4, >(attitude: &T0, angular_velocity: &T1, force: &T2, linear: &mut T3, angular: &mut T4) -> ()
where
  T0: wrenfold_traits::Span2D<4, 1, ValueType = f64>,
  T1: wrenfold_traits::Span2D<3, 1, ValueType = f64>,
  T2: wrenfold_traits::Span2D<3, 1, ValueType = f64>,
  T3: wrenfold_traits::OutputSpan2D<3, 1, ValueType = f64>,
  T4: wrenfold_traits::OutputSpan2D<3, 1, ValueType = f64>,
{
  // Operation counts:
  // add: 43
  // multiply: 69
  // negate: 3
  // total: 115
  
  let v0044: f64 = angular_velocity.get(0, 0);
  let v0047: f64 = angular_velocity.get(2, 0);
  let v0043: f64 = 0.07f64;
  let v0054: f64 = -0.12f64;
  let v0040: f64 = angular_velocity.get(1, 0);
  let v0041: f64 = -0.05f64;
  let v0014: f64 = attitude.get(1, 0);
  let v0006: f64 = 0.625f64;
  let v0004: f64 = force.get(2, 0);
  let v0016: f64 = force.get(1, 0);
  let v0002: f64 = -0.625f64;
  let v0001: f64 = attitude.get(2, 0);
  let v0003: f64 = attitude.get(0, 0);
  let v0007: f64 = force.get(0, 0);
  let v0059: f64 = v0040 * v0054 + v0043 * v0047 + v0044 * 1.3f64;
  let v0067: f64 = 0.02456511058647571f64;
  let v0049: f64 = v0040 * v0041 + v0043 * v0044 + 2.1f64 * v0047;
  let v0084: f64 = -0.01230429432915509f64;
  let v0072: f64 = v0044 * v0054 + v0041 * v0047 + v0040 * 1.7f64;
  let v0063: f64 = -0.02456511058647571f64;
  let v0088: f64 = 0.01230429432915509f64;
  let v0074: f64 = 0.054021504254329326f64;
  let v0053: f64 = -0.054021504254329326f64;
  let v0023: f64 = v0001 * v0002 * v0016 + v0004 * v0006 * v0014;
  let v0018: f64 = v0002 * v0007 * v0014 + v0003 * v0006 * v0016;
  let v0009: f64 = v0002 * v0003 * v0004 + v0001 * v0006 * v0007;
  let v0020: f64 = attitude.get(3, 0);
  let v0012: f64 = 0.3125f64;
  linear.set(0, 0, v0007 * v0012 + v0014 * v0018 + v0020 * v0023 + -(v0001 * v0009));
  linear.set(1, 0, v0012 * v0016 + v0001 * v0023 + v0009 * v0020 + -(v0003 * v0018));
  linear.set(2, 0, -9.80665f64 + v0004 * v0012 + v0003 * v0009 + v0018 * v0020 + -(v0014 * v0023));
  angular.set(0, 0, v0004 * -0.16051017169490567f64 + v0016 * -0.04123351637601576f64 + v0007 * -0.0022119469045786756f64 + v0049 * (-0.7755401063473637f64 * v0040 + v0044 * v0074) + v0059 * (v0047 * v0053 + v0040 * v0063) + v0072 * (v0044 * v0067 + v0047 * 0.7755401063473637f64));
  angular.set(1, 0, v0004 * -0.07004534762892335f64 + v0016 * -0.0014706457798009573f64 + v0007 * 0.032081382254859764f64 + v0059 * (v0047 * -0.5924104677805748f64 + v0040 * v0088) + v0049 * (v0040 * v0053 + v0044 * 0.5924104677805748f64) + v0072 * (v0044 * v0084 + v0047 * v0074));
  angular.set(2, 0, v0004 * 0.003682592684379633f64 + v0016 * 0.04895848278920526f64 + v0007 * 0.09607566923622071f64 + v0044 * (v0072 * -0.4773022725988148f64 + v0049 * v0088) + v0047 * (v0063 * v0072 + v0059 * v0084) + v0040 * (v0049 * v0067 + v0059 * 0.4773022725988148f64));
}