// Names of keys for people. English names are made from the keys where this table has none.

import { language } from './language.js';

const NAMES = {
  name: ['Title', 'Titel'], project: ['Project', 'Projekt'], notes: ['Notes', 'Bemerkungen'], gravity: ['Gravity', 'Fallbeschleunigung'],
  tank: ['Tank', 'Tank'], liquid: ['Liquid', 'Flüssigkeit'], materials: ['Materials', 'Werkstoffe'], record: ['Record', 'Beben'],
  damping: ['Damping', 'Dämpfung'], site: ['Site', 'Standort'], procedures: ['Procedures', 'Verfahren'],
  accepted: ['Accepted gaps', 'Akzeptierte Lücken'], analysis: ['Finite elements', 'Finite Elemente'],
  measured: ['Measured values', 'Messwerte'], published: ['Published values', 'Veröffentlichte Werte'], $schema: ['Schema', 'Schema'],
  client: ['Client', 'Auftraggeber'], document: ['Document', 'Dokument'], revision: ['Revision', 'Revision'], date: ['Date', 'Datum'],
  author: ['Author', 'Verfasser'], checker: ['Checker', 'Prüfer'], approver: ['Approver', 'Freigabe'], language: ['Language', 'Sprache'],
  units: ['Units', 'Einheiten'], shape: ['Shape', 'Form'], radius: ['Inner radius', 'Innenradius'], length: ['Length', 'Länge'],
  breadth: ['Breadth', 'Breite'], strip: ['Strip 1 m wide', 'Streifen von 1 m'], support: ['Support', 'Lagerung'],
  courses: ['Courses', 'Schüsse'], wall_base: ['Joint of wall and base', 'Anschluss Wand–Sohle'], roof: ['Roof', 'Dach'],
  bottom: ['Bottom plate', 'Bodenblech'], foundation: ['Foundation', 'Gründung'], isolators: ['Isolators', 'Isolatoren'],
  staging: ['Staging', 'Traggerüst'], floor_mass: ['Floor mass', 'Masse des Bodens'], floor_centre: ['Centre of the floor', 'Schwerpunkt des Bodens'],
  anchors: ['Anchors', 'Anker'], pressure: ['Gas pressure', 'Gasdruck'], pipes: ['Pipes', 'Rohrleitungen'],
  internals: ['Internal equipment', 'Einbauten'], adjacent_structures: ['Adjacent structures', 'Angrenzende Bauten'],
  height: ['Height', 'Höhe'], thickness: ['Thickness', 'Dicke'], material: ['Material', 'Werkstoff'],
  corrosion_allowance: ['Corrosion allowance', 'Korrosionszuschlag'], measured_thickness: ['Measured thickness', 'Gemessene Dicke'],
  layers: ['Layers', 'Schichten'], reinforcement: ['Reinforcement', 'Bewehrung'], type: ['Type', 'Art'], kind: ['Kind', 'Art'],
  mass: ['Mass', 'Masse'], snow: ['Snow', 'Schnee'], rim: ['Rim height', 'Randhöhe'], width: ['Width', 'Breite'],
  annular_thickness: ['Annular plate thickness', 'Dicke des Ringblechs'], annular_width: ['Annular plate width', 'Breite des Ringblechs'],
  annular_weld: ['Annular weld', 'Naht des Ringblechs'], shell_weld: ['Shell-to-bottom weld', 'Naht Mantel–Boden'],
  connections: ['Connections', 'Anschlüsse'], projection: ['Projection', 'Überstand'], subgrade_modulus: ['Subgrade modulus', 'Bettungsmodul'],
  stiffness: ['Stiffness', 'Steifigkeit'], shear_wave_velocity: ['Shear wave velocity', 'Scherwellengeschwindigkeit'],
  soil_damping: ['Soil damping', 'Dämpfung des Bodens'], embedment: ['Embedment', 'Einbindetiefe'], soil_layers: ['Soil layers', 'Bodenschichten'],
  soil_density: ['Soil density', 'Dichte des Bodens'], soil_poisson_ratio: ["Poisson's ratio of soil", 'Querdehnzahl des Bodens'],
  shell_support: ['Shell support', 'Auflager des Mantels'], friction: ['Friction', 'Reibung'], density: ['Density', 'Dichte'],
  fill_height: ['Fill height', 'Füllhöhe'], grade: ['Grade', 'Sorte'], family: ['Family', 'Gruppe'],
  youngs_modulus: ["Young's modulus", 'Elastizitätsmodul'], poisson_ratio: ["Poisson's ratio", 'Querdehnzahl'],
  yield_strength: ['Yield strength', 'Streckgrenze'], allowable_stress: ['Allowable stress', 'Zulässige Spannung'],
  behaviour: ['Behaviour', 'Verhalten'], count: ['Count', 'Anzahl'], capacity: ['Capacity', 'Tragfähigkeit'],
  attachment_capacity: ['Attachment capacity', 'Tragfähigkeit des Anschlusses'], yield_force: ['Yield force', 'Fließkraft'],
  gap: ['Gap', 'Spiel'], rupture_elongation: ['Elongation at rupture', 'Bruchdehnung'], support_distance: ['Distance of support', 'Abstand der Halterung'],
  allowable_displacement: ['Allowable displacement', 'Zulässige Verschiebung'], uplift: ['Uplift', 'Abheben'], settlement: ['Settlement', 'Setzung'],
  horizontal: ['Horizontal', 'Waagerecht'], internal: ['Overpressure', 'Überdruck'], vacuum: ['Vacuum', 'Unterdruck'],
  ec8: ['Eurocode 8', 'Eurocode 8'], api650: ['API 650', 'API 650'], spectrum: ['Spectrum', 'Spektrum'], ground: ['Ground type', 'Baugrundklasse'],
  ag: ['Ground acceleration a_g', 'Bodenbeschleunigung a_g'], importance: ['Importance factor γ_I', 'Bedeutungsbeiwert γ_I'],
  behaviour_factor: ['Behaviour factor q', 'Verhaltensbeiwert q'], construction_quality: ['Construction quality', 'Herstellungsgüte'],
  vertical: ['Vertical', 'Vertikal'], components: ['Components', 'Komponenten'], reduction_factor: ['Reduction factor ν', 'Abminderungsbeiwert ν'],
  bearing_capacity: ['Bearing capacity', 'Bodenpressung, Widerstand'], ss: ['S_S', 'S_S'], s1: ['S_1', 'S_1'], s0: ['S_0', 'S_0'],
  site_class: ['Site class', 'Standortklasse'], asce7: ['Edition of ASCE 7', 'Ausgabe von ASCE 7'], fa: ['F_a', 'F_a'], fv: ['F_v', 'F_v'], q: ['Q', 'Q'],
  sug: ['Seismic use group', 'Seismische Nutzungsgruppe'], tl: ['T_L', 'T_L'], av: ['Vertical acceleration A_v', 'Vertikalbeschleunigung A_v'],
  design_pressure: ['Design pressure', 'Auslegungsdruck'], joint_efficiency: ['Joint efficiency', 'Schweißnahtfaktor'],
  foundation_weight: ['Foundation weight', 'Gewicht der Gründung'], zone_factor: ['Zone factor Z (1993)', 'Zonenbeiwert Z (1993)'],
  soil_factor: ['Soil factor', 'Bodenbeiwert'], importance_1993: ['Importance (1993)', 'Bedeutung (1993)'],
  is1893: ['IS 1893-2', 'IS 1893-2'], zone: ['Seismic zone', 'Erdbebenzone'], response_reduction: ['Response reduction R', 'Abminderungsbeiwert R'],
  national: ['National code', 'Nationale Norm'], impulsive_reduction: ['Reduction, impulsive', 'Abminderung, impulsiv'],
  sloshing_reduction: ['Reduction, sloshing', 'Abminderung, Schwappen'], sloshing_factor: ['Factor of sloshing', 'Beiwert des Schwappens'],
  sloshing: ['Sloshing', 'Schwappen'], impulsive: ['Impulsive', 'Impulsiv'], convective: ['Convective', 'Konvektiv'],
  scale_to: ['Scale to', 'Skalieren auf'], scale_by: ['Scale by', 'Skalieren mit'], time_factor: ['Time factor', 'Zeitfaktor'],
  resample: ['Resample to', 'Abtasten mit'], run: ['Run', 'Rechnen'], decide: ['Decide', 'Entscheiden'], housner: ['Housner', 'Housner'],
  concrete: ['Concrete', 'Beton'], steel: ['Steel', 'Stahl'], combination: ['Combination', 'Kombination'], gamma_c: ['γ_c', 'γ_c'], gamma_s: ['γ_s', 'γ_s'],
  tightness_class: ['Tightness class', 'Dichtheitsklasse'], check: ['Check', 'Nachweis'], reason: ['Reason', 'Grund'], by: ['By', 'Von'],
  direction: ['Direction', 'Richtung'], area: ['Area', 'Fläche'], diameter: ['Diameter', 'Durchmesser'], spacing: ['Spacing', 'Abstand'],
  from_inner: ['From inner face', 'Von innen'], from_outer: ['From outer face', 'Von außen'], table: ['Table', 'Tabelle'], file: ['File', 'Datei'],
  unit: ['Unit', 'Einheit'], tb: ['T_B', 'T_B'], tc: ['T_C', 'T_C'], td: ['T_D', 'T_D'], te: ['T_E', 'T_E'], tf: ['T_F', 'T_F'],
  vertical_ratio: ['Vertical ratio', 'Vertikales Verhältnis'], source: ['Source', 'Quelle'], note: ['Note', 'Bemerkung'], value: ['Value', 'Wert'],
  nonlinear: ['Nonlinear', 'Nichtlinear'], solid: ['Solid', 'Dreidimensional'], frequency: ['Frequency response', 'Frequenzgang'],
  slab_mass: ['Mass of the slab', 'Masse der Platte'], by_group: ['By group', 'Nach Gruppen'],
};

// German of the keys whose English name is the key itself.
const GERMAN = {
  after_record: 'Nach dem Beben', allow_negative: 'Negativ zulassen', amplitude: 'Amplitude', anchor_force: 'Ankerkraft', applied_peak: 'Aufgebrachte Spitze',
  applied_step: 'Aufgebrachter Zeitschritt', area: 'Fläche', at: 'Bei', attachments: 'Anbauteile', axial_membrane_stress: 'Meridianmembranspannung',
  base_moment: 'Wandfußmoment', base_rotation: 'Verdrehung des Wandfußes', base_shear: 'Gesamterdbebenkraft', bending_stress: 'Biegespannung',
  biaxial_ratio: 'Verhältnis der zweiachsigen Festigkeit', bond: 'Verbund', bottom_mesh: 'Netz des Bodens', brittle: 'Spröde', bulk_modulus: 'Kompressionsmodul', caughey: 'Caughey', cladding: 'Bekleidung',
  characteristic_strength: 'Charakteristische Festigkeit', checkpoint: 'Sicherungspunkt', circumference: 'Umfang', code: 'Norm', coefficient: 'Beiwert',
  coefficients: 'Beiwerte', columns: 'Stützen', compressive_strength: 'Druckfestigkeit', contact: 'Kontakt', convective_mass: 'Konvektive Masse', crack_spacing: 'Rissabstand',
  damper_coefficient: 'Dämpferkonstante', damper_exponent: 'Dämpferexponent', dashpots: 'Dämpfer', design_temperature: 'Auslegungstemperatur',
  displacement_capacity: 'Verschiebungsvermögen', duration: 'Dauer', e_normal: 'E, normal', e_parallel: 'E, parallel', elastic: 'Elastisch', elements: 'Elemente',
  envelope: 'Hüllkurve', factor: 'Faktor', first: 'Erste', follower_pressure: 'Mitgehender Druck', force_stations: 'Höhen für Schnittgrößen',
  fracture_energy: 'Bruchenergie', friction_rate: 'Geschwindigkeitseinfluss der Reibung', friction_slow: 'Reibung bei langsamer Bewegung', from: 'Von', gauges: 'Messstellen',
  ground_damping: 'Dämpfung unter dem Fuß',
  hardening_modulus: 'Verfestigungsmodul', heave: 'Anhebung', holds: 'Hält den Rand rund', hoop_stress: 'Umfangsspannung', hot: 'Bei Auslegungstemperatur', imperfections: 'Imperfektionen', impulsive_mass: 'Impulsive Masse',
  impulsive_period: 'Impulsive Periode', inertia: 'Flächenmoment 2. Grades', initial_stiffness: 'Anfangssteifigkeit', initial_stress: 'Anfangsspannung', insulation: 'Dämmung',
  integration: 'Integration', integrator: 'Zeitintegration', interlayer: 'Zwischenschicht', internal_floating: 'Schwimmdecke', isolator_displacement: 'Verschiebung der Isolatoren',
  kinematic_share: 'Kinematischer Anteil', law: 'Gesetz', live_load: 'Nutzlast', lower_bound: 'Untere Grenze', mass_proportional: 'Massenproportional', memory_limit: 'Speichergrenze',
  mesh: 'Netz', mesh_error: 'Diskretisierungsfehler', missing_mass: 'Fehlende Masse', motion: 'Bewegung', n: 'Anzahl', overturning_moment: 'Kippmoment', parts: 'Teile',
  creep_coefficient: 'Kriechzahl', shrinkage: 'Schwinddehnung', thermal_expansion: 'Wärmedehnzahl', volume_change: 'Volumenänderung',
  prestress: 'Vorspannung', temperature: 'Temperatur', inside: 'Innen', outside: 'Außen', stress_free: 'Spannungsfrei bei',
  contact_tangential: 'Steifigkeit entlang der Wand', liquid_elements: 'Elemente der Flüssigkeit',
  peak: 'Spitze', phase: 'Phase', plane_foot: 'Ebener Fuß', plastic_rotation: 'Plastische Verdrehung', points: 'Punkte', quantity: 'Größe', quake_rotation: 'Drehbeschleunigung des Bodens', ratio: 'Verhältnis',
  rayleigh: 'Rayleigh', reduced: 'Reduziert', refine: 'Verfeinerung', rim_hoop_stress: 'Umfangsspannung am Rand', rings: 'Ringe', rise: 'Stich', roof_mass: 'Dachmasse', rotation_penalty: 'Strafsteifigkeit der Rotation',
  rupture_strain: 'Bruchdehnung', second: 'Zweite', self_weight: 'Eigengewicht', sha256: 'SHA-256', shear_modulus: 'Schubmodul', shear_retention: 'Restschubsteifigkeit',
  shear_retention_strain: 'Dehnung der Restschubsteifigkeit', shell_share: 'Anteil des Mantels', slip: 'Gleitweg', slope: 'Neigung', sloshing_crest: 'Höhe des Wellenkamms', sloshing_height: 'Schwapphöhe', sloshing_period: 'Schwappperiode', sloshing_trough: 'Tiefe des Wellentals', snow_combination: 'Kombinationsbeiwert des Schnees', snapshots: 'Zustände',
  softening_strain: 'Entfestigungsdehnung', spectral_radius: 'Spektralradius', stations: 'Höhen für Spannungen', step: 'Schritt', strength: 'Festigkeit',
  symmetry: 'Symmetrie', tangent_modulus: 'Tangentenmodul', tensile_strength: 'Zugfestigkeit', tension: 'Zug', tension_stiffening: 'Zugversteifung', theta: 'Winkel θ',
  tilt: 'Schiefstellung', time_step: 'Zeitschritt', to: 'Bis', toe_axial_stress: 'Meridianspannung am Druckrand', ultimate_strength: 'Bruchfestigkeit',
  upper_bound: 'Obere Grenze', wall: 'Wand', wall_mass: 'Wandmasse', wave_modes: 'Schwappformen', z: 'Höhe z',
};

// What a key means for one word of another key beside it.
const MEANT = {
  'foundation.thickness': ['kind', {
    ring_wall: ['Height of the ring wall', 'Höhe des Ringfundaments'], slab: ['Thickness of the slab', 'Dicke der Platte'],
  }],
  'foundation.width': ['kind', {
    ring_wall: ['Width of the ring wall', 'Breite des Ringfundaments'], soil: ['Width of the pad under the shell', 'Breite des Polsters unter dem Mantel'],
  }],
};

/** The name of the value at a path; `beside` is the object that it is in. */
export function labelAt(parts, beside) {
  const [by, names] = MEANT[parts.slice(-2).join('.')] ?? [];
  const pair = names?.[beside?.[by]];
  return pair ? pair[language() === 'de' ? 1 : 0] : labelOf(parts.at(-1));
}

/** The name of a key in the language of the page. */
export function labelOf(key) {
  if (typeof key === 'number') return String(key + 1);
  const pair = Object.hasOwn(NAMES, key) ? NAMES[key] : null;
  if (pair) return pair[language() === 'de' ? 1 : 0];
  if (language() === 'de' && Object.hasOwn(GERMAN, key)) return GERMAN[key];
  const words = key.replace(/_/g, ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}
