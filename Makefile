# Elastic rods with Maxima, Gawk and GNU Octave: `make help' says what there is to do.

OCTAVE ?= octave
MODES_LITERAL = $(or $(MODES),7 7)
GENERATED ?= generated
FILES = $(shell git ls-files 2>/dev/null || find . -type f -not -path './output/*' -not -path './.git/*')
VERSION = 1.0

# Paths reach the commands as they were typed, with $, # and quotes, and nothing of the user's own settings does.
override SCENE := $(value SCENE)
override OUTPUT := $(value OUTPUT)
override SURFACE := $(value SURFACE)
override OVER := $(value OVER)
override GENERATED := $(value GENERATED)
export SCENE MODES SOLVER TOLERANCE SIZE OUTPUT PICTURES OCTAVE SURFACE GENERATED FUNCTION ARGUMENT OVER SWEEP
unexport POSIXLY_CORRECT CDPATH
run_octave = $(OCTAVE) --norc --no-gui --no-history --quiet
derive_everything = maxima/derive "$$GENERATED" "$(MODES_LITERAL)"
derive_surface = maxima/derive_surface "$${OUTPUT:-output/surfaces}" "$$SURFACE"
run_with_settings = settings = sweep_settings (); run_command
draw_or_follow = $(if $(FUNCTION)$(ARGUMENT),argument_way (getenv ("FUNCTION"), getenv ("ARGUMENT")),draw_map ())

.PHONY: help setup derive equations simulate models chart stability statics modes campbell response sweep point choices \
	conditioning check check-slurm check-ssh map systems pairs mutants fuzz clean dist

help:
	@echo 'make setup       install what is missing: maxima, gawk, octave, gnuplot, ffmpeg, on Debian OpenBLAS' \
		'[SWEEP=yes: GNU parallel, for sweeps]'
	@echo 'make simulate    simulate and draw SCENE=paper (or a file)' \
		'[MODES="7 7" SOLVER=ode45 TOLERANCE=1e-6 SIZE=1920x1080 OUTPUT=folder PICTURES=no DENSE=1000 EXACT=yes PIECES=4]'
	@echo 'make models      the ladder of models of SCENE=paper, error against seconds: table and chart [BUDGET=60 seconds]'
	@echo 'make derive      derive all equations and translate them into generated/ [MODES="7 7" of the literal form]'
	@echo 'make derive SURFACE=file    derive a surface of one'"'"'s own into output/surfaces/'
	@echo 'make equations   write the derived energies and equations of motion as output/equations.tex [MODES="2 2"]'
	@echo 'make check       run all tests'
	@echo 'make check-slurm a sweep in the queue of a Slurm that the test starts on this machine'
	@echo 'make check-ssh   a sweep on a host, this machine by an sshd that the test starts'
	@echo 'make chart       error against seconds and calls of all integrators: table and chart' \
		'[SCENE=paper MODES="7 7" BUDGET=60 seconds]'
	@echo 'make stability   where integrators turn unstable on SCENE=..., predicted and measured: table and chart;' \
		'without SCENE all about the paper'"'"'s rod'
	@echo 'make statics     where SCENE=paper comes to rest under its loads, stable or not: shape, figures [TIME=0];' \
		'[FACTOR=0:0.05:2] as its forces and moments grow so: path through buckling and snapping, SCENE=roof say'
	@echo 'make modes       natural frequencies and modes of SCENE=paper about its equilibrium: table and shapes' \
		'[FILM="1 2" TIME=0.4 about the state of a run]'
	@echo 'make campbell    frequencies against the speed of rotation, SCENE=spin_up say [SPEEDS=0:0.5:12]: table and diagram'
	@echo 'make response    how the tips of SCENE=two_link_arm answer harmonic loads about its equilibrium' \
		'[FREQUENCIES=0:0.1:50]: table and figure'
	@echo 'make sweep       a scene at many points: table and chart' \
		'[SCENE=swing VARY="rod.length=0.2:0.1:1" OBSERVE="max|tip_y|" ENGINE=parallel JOBS=2 KEEP=yes DRY=yes' \
		'HOSTS="node1,node2" LOAD=4 MEMORY=2G TIME_LIMIT=60]'
	@echo 'make point       a scene with other fields, as a sweep has it: the observed values, and the run'"'"'s files' \
		'[SCENE=swing AT="rod.length=0.2" OBSERVE="max|tip_y|" OUTPUT=folder]'
	@echo 'make choices     all scenes that choose and 198 random ones: chosen models against far richer ones, as a sweep' \
		'[COUNTS="0 5 5 5 5" JOBS=2 TIME_LIMIT=600]'
	@echo 'make conditioning    condition number of the mass matrix of arcs against the number of base functions: table'
	@echo 'make map         the folders of octave/ and the calls between them: output/map.svg, .png' \
		'[FUNCTION=rod_rates ARGUMENT=motion: where that comes from]'
	@echo 'make systems     setup, simulate and check in clean Debian 12, 13 and testing, as root' \
		'[SYSTEMS="trixie" SUITES="rebuild awk" ROOTS=folder]'
	@echo 'make pairs       all pairs of fields and their values: each runs, or is refused with a reason'
	@echo 'make mutants     would the tests notice? Mutations of the sources, those that survive [N=200 SEED=1]'
	@echo 'make fuzz        more of the random round trip [N=10000 SEED=1]'
	@echo 'make dist        an archive of the sources'
	@echo 'make clean       remove what runs have written'

setup:
	@.ci/setup

derive:
	@$(if $(SURFACE),$(derive_surface),$(derive_everything))

equations:
	@maxima/write_equations "$${OUTPUT:-output}" "$(or $(MODES),2 2)"

simulate: entry = driver
models: entry = model_ladder
chart: entry = work_precision
statics: entry = statics
modes: entry = natural_modes
campbell: entry = campbell
response: entry = frequency_response
simulate models chart statics modes campbell response:
	@$(run_octave) --eval 'source octave/toolchain_path.m; command = @$(entry); run_command'

stability:
	@$(run_octave) --eval 'source octave/toolchain_path.m; $(if $(SCENE),command = @scene_stability; run_command,stability ();)'

sweep:
	@$(run_octave) --eval 'source octave/toolchain_path.m; command = @sweep; $(run_with_settings)'

# one point of a sweep, which keeps to one processor: as many run at a time as there are
point:
	@OMP_NUM_THREADS=1 $(run_octave) --eval 'source octave/toolchain_path.m; command = @sweep_point; $(run_with_settings)'

choices: override SCENE = tests/choices/drawn_scene.m
choices:
	@$(run_octave) --eval 'source octave/toolchain_path.m; addpath tests/choices; command = @verify_choices; settings = [sweep_settings(); {"counts", [], "numbers"}]; run_command'

conditioning:
	@$(run_octave) --eval 'source octave/toolchain_path.m; conditioning ();'

check:
	@tests/check

check-slurm:
	@tests/slurm/run

check-ssh:
	@tests/ssh/run

map:
	@$(run_octave) --eval 'source octave/toolchain_path.m; addpath tests/map; $(draw_or_follow);'

systems:
	@tests/systems/run

pairs: pairs-rod pairs-mechanism pairs-surface
pairs-%:
	@$(run_octave) --eval 'source octave/toolchain_path.m; addpath tests/pairs; exit (run_pairs ({"$*"}) > 0);'

mutants:
	@tests/mutants/run

fuzz:
	@tests/roundtrip/run

clean:
	rm -rf output maxima/binary maxima/test-directory-cached \
		generated/.derive-* $(filter-out generated/literal_7_7_%,$(wildcard generated/literal_*))

dist:
	@name=elastic-rod-$(VERSION) && mkdir -p output && \
	tar -czf "output/$$name.tar.gz+" --transform "s,^\(\./\)*,$$name/," $(FILES) && \
	mv "output/$$name.tar.gz+" "output/$$name.tar.gz" && echo "output/$$name.tar.gz"
