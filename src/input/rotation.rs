//! A table of the rotational acceleration of the base, of `analysis.quake_rotation` and `--quake-rotation`.

use oscillator::record::Record;

use super::records::load;

/// Columns of the table.
const HEAD: &str = "time_s,rotation_rad_s2";
/// Form of the table in words.
pub(crate) const FORM: &str =
    "rotational accelerations of the base in equal steps of time from 0, under the head `time_s,rotation_rad_s2`";
/// Largest rotational acceleration [rad/s²]: 5 g at 1 m.
const LARGEST: f64 = 50.0;
/// Most samples.
const MOST: usize = 2_000_000;

/// The rotation of the bytes of a file; the error says what was found instead. `origin` is its name in messages.
pub(crate) fn read(bytes: &[u8], origin: &str) -> Result<Record, String> {
    let text = load::decode(bytes).map_err(|_| "a file that is not text")?;
    let (dt, acceleration) = table(&text)?;
    Ok(Record { name: origin.into(), dt, acceleration, processing: Vec::new() })
}

/// Time step and values of a table; the error says what was found instead.
fn table(text: &str) -> Result<(f64, Vec<f64>), String> {
    let mut lines = text.lines().enumerate().filter(|(_, line)| {
        let line = line.trim();
        !line.is_empty() && !line.starts_with('#')
    });
    let head: String = lines.next().map_or("", |(_, line)| line).chars().filter(|c| !c.is_whitespace()).collect();
    if head != HEAD {
        return Err(format!("the head `{}`", files::text::line(&head)));
    }
    let mut samples: Vec<[f64; 2]> = Vec::new();
    for (number, line) in lines {
        let numbers: Vec<f64> = line.split(',').map_while(|cell| cell.trim().parse().ok()).collect();
        let [time, rotation] = numbers[..] else {
            return Err(format!("line {}: `{}`", number + 1, files::text::line(line)));
        };
        if !time.is_finite() || rotation.is_nan() || rotation.abs() > LARGEST {
            return Err(format!("line {}: {rotation} rad/s² at {time} s, more than {LARGEST} rad/s²", number + 1));
        }
        samples.push([time, rotation]);
        if samples.len() > MOST {
            return Err(format!("more than {MOST} lines"));
        }
    }
    let (Some(first), Some(last), true) = (samples.first(), samples.last(), samples.len() > 1) else {
        return Err(format!("{} sample(s)", samples.len()));
    };
    let dt = (last[0] - first[0]) / (samples.len() - 1) as f64;
    let uneven = |(i, sample): &(usize, &[f64; 2])| (sample[0] - first[0] - *i as f64 * dt).abs() >= 0.05 * dt;
    if let Some((i, sample)) = samples.iter().enumerate().find(uneven) {
        return Err(format!("{} s at sample {}, which is not a step of {dt} s", sample[0], i + 1));
    }
    if first[0].abs() > 0.05 * dt {
        return Err(format!("a first time of {} s, not 0", first[0]));
    }
    Ok((dt, samples.iter().map(|sample| sample[1]).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_in_equal_steps_is_a_rotation_and_no_other_is() {
        let found = table("# of a table\ntime_s, rotation_rad_s2\n0,0\n0.02,-0.15\n0.04,0.2\n").expect("a rotation");
        assert_eq!(found, (0.02, vec![0.0, -0.15, 0.2]));
        for (other, wrong) in [
            ("time_s,acceleration_m_s2\n0,0\n0.02,1\n", "head"),
            ("time_s,rotation_rad_s2\n0,0\n0.02,x\n", "line 3"),
            ("time_s,rotation_rad_s2\n0,0\n0.02,60\n", "50 rad/s²"),
            ("time_s,rotation_rad_s2\n0,0\n0.02,1\n0.05,1\n", "not a step"),
            ("time_s,rotation_rad_s2\n0.02,0\n0.04,1\n", "not 0"),
            ("time_s,rotation_rad_s2\n0,1\n", "1 sample"),
            ("", "head"),
        ] {
            let found = table(other).expect_err(other);
            assert!(found.contains(wrong), "{found}");
        }
    }
}
