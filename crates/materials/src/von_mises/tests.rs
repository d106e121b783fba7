use super::*;

/// Stress after a path of uniaxial strain in the bar.
fn bar(law: &VonMises, path: &[f64]) -> Vec<f64> {
    let mut old = vec![0.0; Law::<1>::history_len(law)];
    let mut new = old.clone();
    path.iter()
        .map(|&strain| {
            let stress = law.respond(&[strain], &old, &mut new).unwrap().stress[0];
            old.copy_from_slice(&new);
            stress
        })
        .collect()
}

/// By hand: E = 200, f_y = 1, E_T = 20 beyond ε = 0.005, unloading over 2 f_y under kinematic and 2 σ under isotropic
/// hardening.
#[test]
fn bilinear_bar_by_hand() {
    let path = [0.015, -0.005];
    // σ = 1 + 20·0.010 = 1.2; elastic down to −0.8 (ε = 0.005), then 20·(−0.010).
    let kinematic = bar(&VonMises::new(200.0, 0.3, 1.0, 20.0, 1.0).unwrap(), &path);
    assert!((kinematic[0] - 1.2).abs() < 1e-12 && (kinematic[1] + 1.0).abs() < 1e-12);
    // Elastic down to −1.2 (ε = 0.003), then 20·(−0.008).
    let isotropic = bar(&VonMises::new(200.0, 0.3, 1.0, 20.0, 0.0).unwrap(), &path);
    assert!((isotropic[0] - 1.2).abs() < 1e-12 && (isotropic[1] + 1.36).abs() < 1e-12);
}

/// Armstrong-Frederick, monotone: b = H/γ (1 − e^(−γ ε_p)); Voce: κ = f_y + Q (1 − e^(−r ε_p)). The implicit step has an
/// error of first order: halving the steps halves it.
#[test]
fn saturating_terms_approach_their_closed_forms() {
    let law = VonMises::new(200.0, 0.3, 1.0, 0.0, 1.0)
        .unwrap()
        .with_back_stress(40.0, 50.0)
        .and_then(|law| law.with_saturation(0.5, 30.0))
        .unwrap();
    let error = |steps: u32| {
        let path: Vec<f64> = (1..=steps).map(|i| 0.05 * f64::from(i) / f64::from(steps)).collect();
        let stress = *bar(&law, &path).last().unwrap();
        let plastic = 0.05 - stress / 200.0;
        stress - 1.0 - 0.8 * (1.0 - (-50.0 * plastic).exp()) - 0.5 * (1.0 - (-30.0 * plastic).exp())
    };
    let (coarse, fine) = (error(100), error(200));
    assert!(fine.abs() < 2e-3 && (coarse / fine - 2.0).abs() < 0.05, "{coarse} {fine}");
}

/// Uniaxial stress in the solid and in plane stress gives the stress of the bar: the lateral strains are those of elasticity
/// plus −½ ε_p.
#[test]
fn three_sizes_agree_under_uniaxial_stress() {
    let law = VonMises::new(210e9, 0.3, 355e6, 2.1e9, 0.4).unwrap();
    let strain = 0.02;
    let mut history = [0.0; 3];
    let stress = law.respond(&[strain], &[0.0; 3], &mut history).unwrap().stress[0];
    let lateral = -0.3 * stress / 210e9 - 0.5 * history[1];
    let plane = law.respond(&[strain, lateral, 0.0], &[0.0; 7], &mut [0.0; 7]).unwrap().stress;
    let solid = law.respond(&[strain, lateral, lateral, 0.0, 0.0, 0.0], &[0.0; 13], &mut [0.0; 13]).unwrap().stress;
    let (p, s) = (plane.map(|x| x / stress), solid.map(|x| x / stress));
    assert!((p[0] - 1.0).abs() < 1e-10 && p[1].abs() < 1e-10, "{p:?}");
    assert!((s[0] - 1.0).abs() < 1e-10 && s[1].abs() < 1e-10 && s[2].abs() < 1e-10, "{s:?}");
}

/// An increment of a hundred times the yield strain, and of a million times, in ideal plasticity.
#[test]
fn huge_increments_return_to_the_surface() {
    let law = VonMises::new(210e9, 0.3, 235e6, 0.0, 1.0).unwrap();
    for scale in [0.1, 1.0, 1e3] {
        let strain = [scale, -0.3 * scale, 0.7 * scale];
        let mut new = [0.0; 4];
        law.respond(&strain, &[0.0; 4], &mut new).unwrap();
        // ε − ε_p has lost the digits that scale/ε_y = 10³ … 10⁶ takes of sixteen.
        let used = Law::<3>::inspect(&law, &strain, &new).utilisation;
        assert!((used - 1.0).abs() < 1e-8 * scale.max(1e-2), "{scale} {used}");
    }
}

#[test]
fn parameters_out_of_range_are_rejected() {
    let text = |law: Result<VonMises, LawError>| law.unwrap_err().to_string();
    assert_eq!(
        text(VonMises::new(1.0, 0.3, -1.0, 0.0, 1.0)),
        "von_mises: yield_stress is -1 Pa, allowed > 0 and finite"
    );
    assert_eq!(
        text(VonMises::new(1.0, 0.3, 1.0, 1.0, 1.0)),
        "von_mises: tangent_modulus is 1 Pa, allowed at least 0 and below 1 Pa"
    );
    assert_eq!(text(VonMises::new(1.0, 0.3, 1.0, 0.0, 1.5)), "von_mises: kinematic_share is 1.5, allowed from 0 to 1");
    let law = VonMises::new(1.0, 0.3, 1.0, 0.0, 1.0).unwrap();
    assert!(law.with_back_stress(f64::NAN, 0.0).is_err() && law.with_saturation(1.0, 0.0).is_err());
    let law = (0..4).try_fold(law, |law, _| law.with_back_stress(1.0, 1.0)).unwrap();
    assert!(law.with_back_stress(1.0, 1.0).is_err());
}

#[test]
fn a_strain_that_is_not_a_number_is_an_error() {
    let law = VonMises::new(1.0, 0.3, 1.0, 0.0, 1.0).unwrap();
    assert!(law.respond(&[f64::NAN, 0.0, 0.0], &[0.0; 4], &mut [0.0; 4]).is_err());
}
