# The front door. `make help` lists what there is.

BUILD := build/release
OPALINE := $(BUILD)/bin/opaline
PYTHON ?= python3
LAUNCHER := $(if $(shell command -v ccache),-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)

MODELS := $(or $(OPALINE_MODELS),../shared/models)
TRUTHS := $(foreach run,bunny_1 bunny_2 bear_1 bear_2,build/truth/$(run).exr)
SCENE_bunny := $(MODELS)/bunny_closed.ply --medium marble --diagonal-mm 50 --cell-mm 0.8 --seconds 170
SCENE_bear := --builtin bear --medium gummy-red --seconds 60

# ccache takes precompiled headers where it knows that no time stamp of theirs matters.
export CCACHE_SLOPPINESS := pch_defines,time_macros

.PHONY: help demo build everything test quick check lint bench bench-gpu figures accuracy contact-sheet format asan tsan fuzz hostile faults properties soak endurance package package-check bare-check install python wheel blender dependencies configure

help:
	@echo 'make demo      build, render the built-in bear: a still, a film, how its light is gathered'
	@echo 'make build     build $(OPALINE)'
	@echo 'make test      build all there is, check every rule of the house, run all tests'
	@echo 'make quick     unit tests and golden pictures of what has changed since they last passed'
	@echo 'make lint      clang-tidy on every source file, whatever was clean before'
	@echo 'make bench     times of every pass on this machine'
	@echo 'make bench-gpu all figures of docs/performance.md on a GPU, into build/; DEVICE=name chooses it'
	@echo 'make figures   the pictures of docs/, from the models; PICTURES=name.jpg chooses, PICTURES=--all makes the long ones too'
	@echo 'make accuracy  the table and heat maps of docs/accuracy.md, from the models: half an hour on two cores'
	@echo 'make contact-sheet  every model and ten awkward bodies, of every medium and three sizes, to look at: hours'
	@echo 'make format    clang-format everything'
	@echo 'make asan      run the tests with the address and undefined-behaviour sanitizers'
	@echo 'make tsan      run what has threads, files, the atlas, films, division, loading and truths in the background, with the thread sanitizer'
	@echo 'make fuzz      every fuzz target for 60 seconds each; SECONDS=600 lets them run longer; needs clang 14'
	@echo 'make hostile   600 wrong, awkward and damaged files, in a table: sentences, pictures, time, memory'
	@echo 'make faults    every Vulkan call and allocation of a scene and of a frame fails once: an hour; STRIDE=10 tries every tenth'
	@echo 'make properties  what holds of every scene, of a thousand drawn at random; SCENES=100 SEED=7 draws others'
	@echo 'make soak      a million small frames with random edits; FRAMES=10000 SEED=2 makes others'
	@echo 'make endurance  the window for an hour of random input, and its memory; MINUTES=10 SEED=2 makes others'
	@echo 'make install   library, program, pages and Python module into PREFIX=folder'
	@echo 'make python    the Python module, into the virtual environment at hand, or PREFIX=folder'
	@echo 'make wheel     the Python module as a wheel in build/release/'
	@echo 'make blender   the add-on for Blender as a zip in build/release/'
	@echo 'make package   a tar.gz of the program that runs on other x86-64 Linux machines'
	@echo 'make package-check  the library alone, shared: builds it, installs it, uses it from another project'
	@echo 'make bare-check  the same, static and shared, in a Debian root with nothing else; as root, needs debootstrap'

dependencies:
	@scripts/install-dependencies.sh

configure: dependencies
	cmake --preset release $(LAUNCHER)

build: configure
	cmake --build --preset release --target opaline

everything: configure
	cmake --build --preset release

demo: build
	$(OPALINE) render --medium jade -o bear.png
	$(OPALINE) render --medium gummy-red --deform wobble:0.05:2 --frames 0:59 --size 256x256 --antialias 2 \
	  --max-clusters 2048 --background 0.02,0.02,0.03 -o bear.mp4
	$(OPALINE) render --aov dsm-irradiance -o bear-light.exr
	@echo
	@echo 'bear.png         the built-in bear, of jade, in the light that comes through it'
	@echo 'bear.mp4         the same bear of red gummy, wobbling for two seconds'
	@echo 'bear-light.exr   the light that has entered its skin, laid out flat'
	@echo 'Next: $(OPALINE) render YOUR_MODEL.glb --medium wholemilk --diagonal-mm 50 -o picture.png'

check:
	$(PYTHON) tools/check_names.py
	$(PYTHON) tools/check_layers.py
	$(PYTHON) tools/check_documented.py
	$(PYTHON) tools/check_links.py
	$(PYTHON) tools/check_format.py
	$(PYTHON) -m unittest discover -q -s tests/tools -p '*_test.py'
	$(PYTHON) -m unittest discover -q -s tests/bench -p '*_test.py'

test: everything check
	$(PYTHON) tools/check_tidy.py $(BUILD)
	scripts/fetch-ray-query-device.sh build/ray-query-device
	$(PYTHON) tools/run_tests.py release --jobs 3

quick: configure
	cmake --build --preset release --target opaline_quick_tests
	$(PYTHON) tools/run_tests.py release --jobs 2 --quick

lint: everything
	$(PYTHON) tools/check_tidy.py $(BUILD) --all

bench: everything
	$(BUILD)/bin/opaline_frame_bench
	$(BUILD)/bin/opaline_edit_bench
	$(BUILD)/bin/opaline_motion_bench
	$(BUILD)/bin/opaline_soft_body_bench

bench-gpu: everything
	$(PYTHON) bench/bench_gpu.py $(BUILD)/bin build --device "$(DEVICE)"

figures: everything $(TRUTHS)
	$(PYTHON) tools/make_pictures.py --build $(BUILD) $(PICTURES)

# What boundary transport is shown beside: 8 minutes in all.
$(TRUTHS): | build
	mkdir -p $(@D)
	$(OPALINE) reference $(SCENE_$(word 1,$(subst _, ,$(@F)))) --path --directional 0.45,0.35,-0.82:3.14159,3.14159,3.14159 \
	  --size 256x256 --aov exitance --seed $(subst .exr,,$(word 2,$(subst _, ,$(@F)))) -o $@

accuracy: build
	$(PYTHON) tools/accuracy.py --program $(OPALINE)

contact-sheet: build
	$(PYTHON) tools/contact_sheet.py --program $(OPALINE)

format:
	$(PYTHON) tools/check_format.py --fix

asan: dependencies
	cmake --preset asan $(LAUNCHER)
	cmake --build --preset asan
	LSAN_OPTIONS=print_suppressions=0:suppressions=$(CURDIR)/tools/lsan.supp $(PYTHON) tools/run_tests.py asan

tsan: dependencies
	cmake --preset tsan $(LAUNCHER)
	cmake --build --preset tsan --target test_core test_atlas test_threads test_jobs
	build/tsan/bin/test_core
	build/tsan/bin/test_threads
	TSAN_OPTIONS=suppressions=$(CURDIR)/tools/tsan.supp build/tsan/bin/test_jobs \
	  --gtest_filter=-TruthJob.Integral*:TruthJob.Particles*:TruthJob.Without*:TruthJob.Takes*:TruthJob.Shows*
	build/tsan/bin/test_atlas --gtest_filter=Atlas.IsTheSameEveryTime:Atlas.FlatSheet*:Atlas.Gutter*

fuzz: dependencies
	$(PYTHON) tools/fuzz.py --seconds $(or $(SECONDS),60)

hostile: build
	$(PYTHON) tools/hostile.py --program $(OPALINE) --models $(MODELS)

faults: configure
	cmake --build --preset release --target test_faults test_allocation_faults
	OPALINE_FAULT_STRIDE=$(or $(STRIDE),1) $(BUILD)/bin/test_faults
	OPALINE_FAULT_STRIDE=$(or $(STRIDE),1) $(BUILD)/bin/test_allocation_faults

properties: configure
	cmake --build --preset release --target test_properties
	OPALINE_SCENES=$(or $(SCENES),1000) OPALINE_SEED=$(or $(SEED),1) $(BUILD)/bin/test_properties

soak: configure
	cmake --build --preset release --target opaline_soak
	$(BUILD)/bin/opaline_soak $(or $(FRAMES),1000000) $(or $(SEED),1)

package: build
	scripts/package.sh $(BUILD)
	scripts/test-package.sh

package-check: dependencies
	cmake --preset library -B build/shared -DBUILD_SHARED_LIBS=ON $(LAUNCHER)
	cmake --build build/shared
	cd tests/package && BUILD=$(CURDIR)/build/shared $(PYTHON) -m unittest package_test same_pictures_test

bare-check:
	scripts/test-bare-library.sh build/bare

endurance: configure
	cmake --build --preset release --target opaline fault_layer
	cd tests/viewer && OPALINE=$(CURDIR)/$(OPALINE) OPALINE_MINUTES=$(or $(MINUTES),60) OPALINE_SEED=$(or $(SEED),7) \
	  PYTHONPATH=../cli $(PYTHON) -m unittest endurance_test

install: configure
	cmake --build --preset release --target opaline opaline_library opaline_python
	cmake --install $(BUILD) $(PREFIX:%=--prefix %)

wheel: configure
	cmake --build --preset release --target opaline_wheel

blender: configure
	cmake --build --preset release --target opaline_blender

# pip refuses to change a system's own Python: use a virtual environment with NumPy, or PREFIX.
python: wheel
	$(or $(VIRTUAL_ENV:%=%/bin/python),$$(sed -n 's/^OPALINE_PYTHON_EXECUTABLE:[^=]*=//p' $(BUILD)/CMakeCache.txt)) -m pip \
	  install --no-deps --force-reinstall $(PREFIX:%=--prefix %) $(BUILD)/opaline-*.whl
