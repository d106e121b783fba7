//! The catalogue of codes: id, severity, title, explanation, example. One table, so longer than other files.
//!
//! To add a code, add an entry with a new id at the end of its hundred, write `docs/codes.md`
//! (`tankcheck explain --format markdown > docs/codes.md`) and add its trigger to `tests/cli/codes.rs`.

use super::Severity;

macro_rules! catalogue {
    ($($name:ident $id:literal $severity:ident $title:literal $explanation:literal $example:literal)*) => {
        /// A kind of error or warning.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Code {
            $(#[doc = $title] $name,)*
        }

        impl Code {
            /// All codes, in the order of their ids.
            pub const ALL: [Code; [$(Code::$name),*].len()] = [$(Code::$name),*];

            /// The stable id.
            pub fn id(self) -> &'static str {
                match self { $(Code::$name => $id),* }
            }

            /// Error or warning.
            pub fn severity(self) -> Severity {
                match self { $(Code::$name => Severity::$severity),* }
            }

            /// The kind in a few words.
            pub fn title(self) -> &'static str {
                match self { $(Code::$name => $title),* }
            }

            /// What it means, why it stops the run or does not, what to do.
            pub fn explanation(self) -> &'static str {
                match self { $(Code::$name => $explanation),* }
            }

            /// What leads to it, or what mends it.
            pub fn example(self) -> &'static str {
                match self { $(Code::$name => $example),* }
            }

            /// Its name in the sources, for tests of its use.
            pub fn name(self) -> &'static str {
                match self { $(Code::$name => stringify!($name)),* }
            }
        }
    };
}

catalogue! {
    Usage "T0101" Error "the command line cannot be read"
        "A subcommand, an option or an argument is unknown, missing or given twice. The message shows the usage; `tankcheck \
         COMMAND --help` lists all options with examples."
        "tankcheck check tank.json --quakes elcentro.csv   # the option is --quake"

    OptionValue "T0102" Error "the value of an option is not allowed"
        "The option exists, its value cannot be used: not a number, outside its range, or in another form. The message gives \
         the value found and the values allowed. Options are checked before anything is computed."
        "tankcheck spectrum elcentro.csv --damping 120%   # ratios are below 100 %"

    OptionConflict "T0103" Error "options that do not fit together"
        "An option needs another one, excludes it, or applies to another engine or form of output. Options without effect are \
         refused, so that a run is what its command says."
        "tankcheck check tank.json --select checks   # parts are selected of --format json"

    MissingInput "T0104" Error "an input that this command needs is missing"
        "The command cannot do anything without a ground motion, a period or a limit that only you know. Nothing is assumed \
         in its place."
        "tankcheck compare tank.json   # add site to the tank file, or --quake RECORD"

    UnknownId "T0105" Error "an unknown id on the command line or in a list"
        "A procedure, benchmark, subcommand, code or part of the results with this name does not exist. The message lists \
         those that do, or the nearest ones."
        "tankcheck check tank.json --procedures ec9   # EN 1998-4 is ec8"

    Syntax "T0201" Error "the file is not valid JSON"
        "A comma, colon, quote or bracket is missing, or in the wrong place. Comments (`//`, `/* */`) and commas after the \
         last item are allowed in tank and study files; single quotes and words without quotes are not."
        "{ name: 'Tank 1' }   // write { \"name\": \"Tank 1\" }"

    CutOff "T0202" Error "the file ends too early"
        "A bracket or quote is never closed, or a header counts more lines or numbers than the file has. The file was cut \
         off, or its header is wrong. What is there is not used: half of a record is another earthquake."
        "NPTS= 4000, DT= .01000 SEC   # followed by 3120 values"

    EmptyFile "T0203" Error "the file is empty"
        "The file has no content, only comments, or no numbers where numbers are expected. `tankcheck init` writes a tank \
         file to start from."
        "tankcheck init --out tank.json"

    TooLarge "T0204" Error "the file is larger or deeper than this program reads"
        "Input is limited so that a wrong file, such as an archive, is refused at once instead of filling the memory: sizes of \
         files, samples of a record, levels of objects and lists. The message gives the limit."
        "tankcheck quake info archive.zip   # 300 MB"

    DuplicateKey "T0205" Error "a key occurs twice in an object"
        "JSON readers keep one of the two and drop the other without a word. Remove the one that is not meant."
        "{ \"radius\": \"15 m\", \"radius\": \"16 m\" }"

    UnknownKey "T0206" Error "an unknown key"
        "The file has a key that this object does not know: misspelt, in the wrong object, or about something that is not \
         supported. Unknown keys are never ignored, because a misspelt key would leave a default in force. The help names \
         the key that is meant, or says what is supported in its place; `docs/input.md` lists all keys."
        "\"tank\": { \"diameter\": \"30 m\" }   // \"radius\": \"15 m\""

    MissingKey "T0207" Error "a required key is missing"
        "The value has no default: it decides the result and only you know it. The help shows the line to add."
        "\"liquid\": { \"density\": \"1000 kg/m3\" }   // fill_height is missing"

    WrongKind "T0208" Error "a value of another kind than the key takes"
        "A list stands where a number belongs, a number where an object belongs, and so on. The message says what the key \
         takes."
        "\"courses\": \"8 mm\"   // a list of courses: [ { … } ]"

    UnknownChoice "T0209" Error "a word that is not among the choices"
        "The key takes one of a few words, or the name of a material, grade, procedure or quantity, and this word is not \
         one of them. The message lists the choices; the help names the nearest."
        "\"support\": \"anchord\"   // \"anchored\" or \"unanchored\""

    NotANumber "T0210" Error "a text that is not a number"
        "A number is expected and the text does not begin with one, or continues after it. The decimal mark is a point, also \
         in German files; groups of digits are not separated. In records the decimal comma is read where columns are \
         separated by semicolons or tabs."
        "\"radius\": \"1,83 m\"   // \"1.83 m\""

    NotFinite "T0211" Error "a number that is not finite"
        "NaN and infinity are not input: a record with one of them has a gap, and a tank has finite dimensions."
        "0.02, nan"

    UnitMissing "T0212" Error "a value without its unit"
        "A quantity with a dimension is written with its unit in quotes. Units are never guessed from the size of the number."
        "\"radius\": 15   // \"15 m\""

    UnitUnknown "T0213" Error "an unknown unit"
        "The unit is misspelt or not supported. The message lists the units of the quantity."
        "\"radius\": \"15 meters\"   // \"15 m\""

    UnitOfOther "T0214" Error "a unit of another quantity"
        "The unit exists but belongs to another quantity, such as a mass where a length belongs."
        "\"radius\": \"15 kg\""

    OutOfRange "T0215" Error "a value outside its range"
        "The value is impossible (negative, zero, beyond what physics or the code allows) or outside what a reader or engine \
         takes. The message gives the range. Values that are possible but unusual are computed with a warning."
        "\"poisson_ratio\": 0.7   // from 0 to below 0.5"

    ItemCount "T0216" Error "too few or too many items"
        "A list is empty, or longer than this program or the model takes. The message gives the numbers allowed."
        "\"courses\": []"

    BadForm "T0217" Error "a text in another form than expected"
        "The text has a fixed form: a date, a mesh, a hash, a pattern, a rule. The message shows the form."
        "\"date\": \"14.3.2026\"   // \"2026-03-14\""

    Repeated "T0218" Error "an item that must not be repeated"
        "Two entries of a list are the same or have the same name, frequency or place, so that one of them has no meaning."
        "\"run\": [\"ec8\", \"ec8\"]"

    Contradiction "T0301" Error "values that contradict each other"
        "Each value is possible, together they are not: bars outside their shell, a roof heavier than the liquid, a tensile \
         strength below the yield strength. The message names the limit that follows from the other value."
        "\"annular_thickness\": \"6 mm\" with \"thickness\": \"8 mm\""

    LiquidAboveWall "T0302" Error "the liquid is higher than the wall"
        "`liquid.fill_height` exceeds the sum of the heights of `tank.courses`. Check whether the height of the wall is complete \
         (all courses) and both have the same datum, the bottom plate."
        "\"fill_height\": \"12 m\" with courses of 10 m in all"

    DoesNotApply "T0303" Error "a key that does not apply to this input"
        "The key belongs to another shape, support, material or model, and has no effect here. It is refused instead of \
         ignored: the file would promise something that is not computed. Remove it, or change the key on which it depends."
        "\"shape\": \"rectangle\" with \"radius\": \"5 m\""

    Exclusive "T0304" Error "keys that exclude each other"
        "The same thing is given in two ways, or not exactly one of several alternatives is chosen. Keep the one that \
         is meant."
        "\"scale_to\": \"0.3 g\" with \"scale_by\": 2"

    Incomplete "T0305" Error "a group of keys that is incomplete"
        "Some keys have a meaning only together: a width with its thickness, an interlayer with shells on both sides, Fa with \
         Fv. The message names the missing part."
        "\"annular_thickness\": \"12 mm\" without \"annular_width\""

    Unsupported "T0306" Error "this tank or motion is outside the model of the engine or procedure"
        "The input is sound; the chosen engine does not model it, and a result would leave something out without saying so. \
         The help names what to change or another engine."
        "--fe nonlinear with a concrete law that it does not have"

    RecordFormat "T0401" Error "the format of the record cannot be read"
        "The file is not one of the formats of records, or a line of its header is not what the format says. Read are CSV and \
         text of one or two columns, PEER .AT2, ESM, K-NET, USGS SMC, COSMOS and CSMIP volume 2."
        "# convert its acceleration to a CSV file with the header time_s,acceleration_m_s2"

    NotAcceleration "T0402" Error "the record is not an acceleration"
        "The file holds velocities or displacements (PEER .VT2, .DT2, COSMOS parameters other than 1). They are not \
         differentiated: the result depends on the filter. Take the acceleration of the same record."
        "DATA_TYPE: VELOCITY"

    RecordUnit "T0403" Error "the unit of acceleration is missing, unknown or given twice"
        "The unit is taken from the file or from --units and never guessed from the size of the numbers, because 0.3 can be g \
         and m/s². Where both are given they must agree."
        "tankcheck spectrum record.txt --dt 0.01 --units g"

    TimeStep "T0404" Error "the time step is missing, faulty or not uniform"
        "A record has one time step, from its header, its time column or --dt. Steps that differ, go backwards, or look like \
         milliseconds are refused; a gap in a record is not filled."
        "0.00, 0.01, 0.02, 0.04   # the step changes"

    RecordLength "T0405" Error "a number of samples other than the header says"
        "The header counts other samples than the file has, or the record has fewer than two. One of the two is wrong; \
         correct the header or take the file again from its source."
        "NPTS= 4000 with 4012 values"

    RecordChannel "T0406" Error "the channel of the record is not clear"
        "The file has several channels and --channel does not name one of them, or it has one and --channel is given."
        "tankcheck quake info v2.txt --channel 3"

    PeakAcceleration "T0407" Error "an implausible peak ground acceleration"
        "The peak is zero, above 5 g (the largest recorded are near 3 g) or above 1000 g. The usual reason is a wrong unit or \
         factor. --allow-implausible accepts up to 1000 g."
        "gal read as m/s2: 3.4 m/s2 becomes 340 m/s2"

    TableShape "T0501" Error "a table that cannot be read"
        "A row has another number of cells than the head, a quote is not closed, or a table has no or too many rows."
        "name,tank.radius\nT1   # one cell"

    TableColumn "T0502" Error "an unknown, missing or repeated column"
        "The columns of a table are found by their names. Those of a table of tanks are paths of the tank file."
        "fillheight   # liquid.fill_height"

    TableValue "T0503" Error "a cell that cannot be used"
        "The cell is not a number in the range of its column, or contradicts another cell of its row."
        "im,n,exceed\n0.3,10,12   # more than n"

    StudyChanged "T0504" Error "the study file does not belong to its plan"
        "Tanks, records or scales have changed since the study was planned. Plan again: results whose input is unchanged are \
         kept."
        "tankcheck study plan study.json --out farm/"

    StudyIncomplete "T0505" Error "tasks of the study have no result"
        "`study merge` takes all tasks, and some have not run or failed. Run them, or merge what there is with --partial, which \
         states how many are missing."
        "tankcheck study merge farm/ --partial"

    FileUnreadable "T0601" Error "a file or folder that cannot be read"
        "The file does not exist, is a folder, is not text, or the system does not allow it to be read. Nothing was computed."
        "tankcheck check tanks.json   # the file is tank.json"

    FileTaken "T0602" Error "a file or folder that must not be overwritten"
        "The output folder holds results of another kind of run, files that tankcheck did not write, or files that were changed \
         since; or another run uses it. Nothing is overwritten or removed. Name another folder, or move the old one."
        "tankcheck push tank.json --out out/   # out/ holds a comparison"

    NotWritten "T0603" Error "results that cannot be written"
        "The disk is full, the folder disappeared or is read-only. Complete results of an earlier run are still there."
        "error[T0603]: out/results.json: the results cannot be written: no space left on the device"

    Output "T0604" Error "standard output cannot be written"
        "The result was computed and could not be printed, for instance because a device is full. A reader that closes \
         early, as in `| head`, is not an error."
        "tankcheck check tank.json > /dev/full"

    NotResults "T0605" Error "a file or folder that is not what this command reads"
        "A results folder of another command or format version, or a file that is not what its name says. The message gives \
         what was found and what is read."
        "tankcheck report ida/   # `tankcheck ida` writes a complete report.html itself"

    Report "T0606" Error "the report cannot be rendered"
        "A template of --templates is faulty or misses a part, or the results lack something that a section needs. The \
         results are kept; `tankcheck report FOLDER` renders them again."
        "tankcheck report out/ --templates mine/"

    Checkpoint "T0607" Error "a checkpoint that cannot be used"
        "The checkpoint is damaged, or belongs to another tank, record, option or version. Omit --resume to start over."
        "tankcheck compare tank.json --fe nonlinear --quake b.csv --resume a.ckpt"

    ProgramMissing "T0608" Error "a program that this command starts is not there"
        "Printing needs a Chromium, documents need pandoc. Nothing was written; the message says how to install the program. The \
         report itself is HTML and opens in any browser."
        "CHROME=/opt/chrome/chrome tankcheck report out/ --pdf"

    Procedure "T0701" Error "a code procedure failed"
        "An iteration of the procedure did not converge or a formula gave no value. Limits of a code's scope are not errors: \
         the method is then listed as not applicable, with its clause."
        "error[T0701]: ec8: EN 1998-4:2006 A.3.1: no convergence"

    NotPositiveDefinite "T0702" Error "a matrix that must be positive definite is not"
        "The model can move without resistance, or a mass or stiffness is negative: an extreme ratio of thickness to radius, \
         a modulus many orders of magnitude off. Check the input that the message names."
        "error[T0702]: stiffness of the wall is not positive definite"

    Eigenvalues "T0703" Error "the eigenvalue solver failed"
        "The modes of the model were not found to the required accuracy. Extreme proportions are the usual reason."
        "error[T0703]: eigenvalue solver: no convergence"

    Memory "T0704" Error "the run needs more memory than allowed"
        "The need is estimated before anything is built. The help gives a mesh that fits, or the option that allows more."
        "tankcheck compare tank.json --fe solid --mesh 200x200x200"

    TooLong "T0705" Error "the run is longer than allowed"
        "The number of steps, samples or the estimated time is beyond the limit, usually because of a time step or an \
         after-record that is not meant. The help gives a value that fits."
        "--after-record 100000s"

    Analysis "T0706" Error "the analysis failed"
        "Newton's method, a contact or an integration found no solution. The message gives the instant and the reason; \
         results up to there are kept where the command says so."
        "error[T0706]: no equilibrium at t = 3.21 s"

    ResultNotFinite "T0707" Error "a result that is not finite"
        "A computed value is NaN or infinite and is not written. Either the input has extreme values, or this is a fault of \
         the program; please report it."
        "error[T0707]: the computation gave NaN for base_shear"

    Interrupted "T0708" Error "the run was interrupted before it had results"
        "Ctrl-C came before anything could be kept. Runs with --checkpoint, `ida` and `study` keep what is done."
        "error[T0708]: interrupted during assembly; there are no results yet"

    Base "T0709" Error "the base of the tank has no equilibrium"
        "The bottom plate on its ground does not hold the moment or uplift that is asked for, or a parameter of it has no \
         meaning. Ask for less uplift or rotation, or check plate and ground."
        "tankcheck base tank.json --rotation 0.5"

    Benchmark "T0710" Error "a benchmark has no answer"
        "A model of the verification manual that must have a solution has none. This is a fault of the program or of the \
         machine; please report it."
        "cargo run --release -p verification"

    Internal "T0711" Error "a fault of the program"
        "Something happened that the program excludes. Partial files were removed, complete ones are kept. Please report it \
         with the line, the command and its input files."
        "error[T0711]: internal fault at src/a.rs:7: …"

    UnusualTank "T0901" Warning "an unusual tank or material"
        "The value is possible and was used; it is outside the range in which tanks are built or in which procedures and \
         engines were verified. Check its unit."
        "H/R of 12"

    NotUsed "T0902" Warning "input that has no effect in some or all methods"
        "The key was read, and the methods that the message names leave it out, or nothing uses it. Results of these methods \
         are those of a tank without it."
        "\"pressure\" enters the codes' checks; the engines leave it out"

    UnusualRecord "T0903" Warning "an unusual record"
        "The record was used; its number of samples, time step or factor is unusual, or a set of records does not hold for its \
         target spectrum. Periods shorter than about ten steps are not in a record."
        "a time step of 0.2 s"

    UnusedAcceptance "T0904" Warning "an accepted gap that is none"
        "`accepted` names a limit state that was checked, fails, is not required or does not exist. Only what was not checked \
         can be accepted."
        "\"accepted\": [ { \"check\": \"slidding\", \"reason\": \"…\", \"by\": \"…\", \"date\": \"…\" } ]"

    LimitExceeded "T0905" Warning "a run that left the limits of its theory"
        "The results were computed, and a response is beyond what the theory of the engine covers, such as a wave that breaks \
         or a wall that yields in a linear run. Do not use the values that depend on it."
        "a wave higher than the theory of small waves covers"

    Unusable "T0906" Warning "a value that is not to be used"
        "The value is printed for completeness and marked; its method does not describe this tank. It does not enter a \
         verdict."
        "hoop stress of a membrane formula at a clamped foot"

    LiquidParted "T0907" Warning "the liquid parts from the wall"
        "The total pressure becomes negative at the wall, which a liquid that stays in contact does not follow. The estimate \
         is linear; --fe nonlinear with \"contact\": \"opening\" follows it."
        "a slender tank under a strong record"

    PartlyKept "T0908" Warning "results or checkpoints that are not all kept"
        "The run goes on or ended early: a checkpoint could not be written or removed, a report or file is missing. The \
         message says what is there and what is not."
        "the disk filled up while a checkpoint was written"

    PushAssumption "T0909" Warning "an assumption of the pushover that may not hold"
        "The pushover was computed with a model that leaves something out for this tank. Read its limits before using the \
         capacity."
        "a mesh that is coarse for the buckles of this wall"

    ChangedResults "T0910" Warning "results that changed since they were written"
        "A file of the folder does not have the hash of its manifest any more. The report shows the changed file."
        "an edited series.csv"

    BaseModel "T0911" Warning "the base is modelled without something that the tank has"
        "`tankcheck base` leaves out yielding or anchors of this tank; the message says which."
        "a bottom plate without yield strength is elastic"

    StudyRemark "T0912" Warning "a study that is incomplete or unusual"
        "Rows of the study failed, are missing or are outside a limit; the message counts them. Curves say how they treat \
         them."
        "tankcheck study merge farm/ --partial"

    Replaced "T0913" Warning "files of earlier results are removed"
        "The output folder held results of an earlier run, and the new results have fewer files: without --no-report a report, \
         without finite elements no histories. A run of another engine, under a record, or a printed report is named before the new run \
         begins. Files of the earlier run that have no successor are removed, so that a folder \
         never mixes two runs. Name another folder to keep both."
        "tankcheck compare tank.json --no-report --out out/   # out/ had a report"

    UnusualInput "T0914" Warning "an unusual input"
        "The value is within the range of the code and was used; it is outside the range that the code recommends or that such tanks \
         have. The report lists it in its summary."
        "\"importance\": 0.7"

    Inconsistent "T0915" Warning "inputs that contradict each other"
        "Two values of the file describe the same thing and do not agree. Each was used where it stands. The report lists them in its \
         summary."
        "ground type B with 80 m/s"
}
