use super::*;

fn law() -> DruckerPrager {
    DruckerPrager::new(34e9, 0.2, 35e6, 1.16 * 35e6).unwrap()
}

/// α = 0.16/(√3·1.32) and k = 1.16/(√3·1.32) f_c.
#[test]
fn cone_of_two_strengths() {
    let cone = law().cone();
    assert!((cone.alpha - 0.069_982).abs() < 1e-6 && (cone.k / 35e6 - 0.507_368).abs() < 1e-6);
    // Both strengths lie on it: uniaxial √J_2 = f/√3, equibiaxial √J_2 = f/√3 with I_1 = −2 f.
    assert!((35e6 / 3f64.sqrt() - cone.alpha * 35e6 - cone.k).abs() < 1e-6);
    assert!((1.16 * 35e6 * (1.0 / 3f64.sqrt() - 2.0 * cone.alpha) - cone.k).abs() < 1e-6);
}

/// The plane return is the one of the solid whose strain through the thickness makes σ_zz = 0, ideal and hardening.
#[test]
fn plane_stress_agrees_with_the_solid() {
    for hardening in [0.0, 3e9] {
        let law = law().with_hardening(hardening).unwrap();
        let (mut plane_old, mut solid_old) = (vec![0.0; 5], vec![0.0; 7]);
        let (mut plane_new, mut solid_new) = (vec![0.0; 5], vec![0.0; 7]);
        for strain in [[-2e-3, 1e-4, 3e-4], [-2.5e-3, -1e-3, 2e-3], [1e-3, -1e-3, -1e-3]] {
            let plane = law.respond(&strain, &plane_old, &mut plane_new).unwrap();
            // ε_zz = ε_zz,e + ε_zz,p from the plane solution.
            let [x, y, _] = plane.stress;
            let thick = -0.2 * (x + y) / 34e9 + plane_new[4];
            let full = [strain[0], strain[1], thick, strain[2], 0.0, 0.0];
            let solid = law.respond(&full, &solid_old, &mut solid_new).unwrap();
            let expected = [x, y, 0.0, plane.stress[2], 0.0, 0.0];
            for i in 0..6 {
                assert!((solid.stress[i] - expected[i]).abs() < 1e-7 * 35e6, "{solid:?} {plane:?}");
            }
            assert!((solid.dissipation - plane.dissipation).abs() < 1e-9 * 35e6);
            plane_old.copy_from_slice(&plane_new);
            solid_old.copy_from_slice(&solid_new);
        }
    }
}

/// Hydrostatic tension ends at the apex p = k/(3α), beyond which the stiffness is 0.
#[test]
fn apex_in_the_solid() {
    let law = law();
    let answer = law.respond(&[0.01, 0.01, 0.0102, 1e-5, 0.0, 0.0], &[0.0; 7], &mut [0.0; 7]).unwrap();
    let p = law.cone().k / (3.0 * law.cone().alpha);
    assert!((0..3).all(|i| (answer.stress[i] / p - 1.0).abs() < 1e-12));
    assert!(answer.stress[3].abs() < 1e-9 * p && answer.tangent == [[0.0; 6]; 6]);
}

/// Increments of a thousand times the strain at failure, all around; of twenty times with hardening.
#[test]
fn huge_increments_return_to_the_surface() {
    for (hardening, scale) in [(0.0, 1.0), (1e9, 0.02)] {
        let law = law().with_hardening(hardening).unwrap();
        for k in 0..72 {
            let (sine, cosine) = (f64::from(k) * 5f64.to_radians()).sin_cos();
            for shear in [0.0, 1.0] {
                let strain = [cosine, sine, shear].map(|x| scale * x);
                let mut new = [0.0; 5];
                law.respond(&strain, &[0.0; 5], &mut new).unwrap();
                let used = Law::<3>::inspect(&law, &strain, &new).utilisation;
                // ε − ε_p loses three digits.
                assert!((used - 1.0).abs() < 1e-8, "{strain:?} {used}");
            }
        }
    }
}

#[test]
fn parameters_out_of_range_are_rejected() {
    let text = |law: Result<DruckerPrager, LawError>| law.unwrap_err().to_string();
    assert_eq!(
        text(DruckerPrager::new(1.0, 0.2, 1.0, 0.5)),
        "drucker_prager: f_bc is 0.5 Pa, allowed from 1 to 1.5 Pa"
    );
    assert_eq!(text(DruckerPrager::new(1.0, 0.2, -1.0, 1.0)), "drucker_prager: f_c is -1 Pa, allowed > 0 and finite");
    let cone = Cone { alpha: 0.3, k: 1.0 };
    assert!(DruckerPrager::of_cone(1.0, 0.2, cone).is_err() && law().with_hardening(-1.0).is_err());
}
