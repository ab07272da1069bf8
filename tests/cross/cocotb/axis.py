"""cocotb: the AXI4-Stream form of a pipeline against the numpy oracle, with random pauses on both sides."""

import itertools
import logging
import os
import random
from pathlib import Path

import cocotb
import numpy as np
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge
from cocotbext.axi import AxiStreamBus, AxiStreamFrame, AxiStreamSink, AxiStreamSource

import oracle

TOP = os.environ["PIPELINE"]
HEADER = Path(os.environ["FOLDER"], f"{TOP}.h").read_text()
COUNT = int(os.environ.get("COUNT", "400"))


async def start(dut):
    """Clock, reset, and the two ends of the stream."""
    cocotb.start_soon(Clock(dut.aclk, 10, unit="ns").start())
    source = AxiStreamSource(AxiStreamBus.from_prefix(dut, "s_axis"), dut.aclk, dut.aresetn, reset_active_level=False)
    sink = AxiStreamSink(AxiStreamBus.from_prefix(dut, "m_axis"), dut.aclk, dut.aresetn, reset_active_level=False)
    for end in (source, sink):
        end.log.setLevel(logging.WARNING)
    dut.aresetn.value = 0
    await ClockCycles(dut.aclk, 3)
    dut.aresetn.value = 1
    await RisingEdge(dut.aclk)
    return source, sink


async def transfer(source, sink, operands):
    """Sends the operands with alternating tags; returns the results as bytes and the tags."""
    for position, words in enumerate(operands):
        source.send_nowait(AxiStreamFrame(words.tobytes(), tuser=position % 2))
    frames = [await sink.recv(compact=False) for _ in operands]
    first = lambda user: user[0] if isinstance(user, list) else user
    return b"".join(bytes(frame.tdata) for frame in frames), [int(first(frame.tuser)) for frame in frames]


def judge(operands, results):
    """Compares what means something: of a miss nothing, of one child the near slot."""
    if TOP.startswith("dual_split"):
        code, near, far = oracle.dual_split(operands)
        assert np.array_equal(results["code"], code), f"codes differ first at {np.argmax(results['code'] != code)}"
        assert set(code) == {0, 1, 2, 3}
        for slot, expected, is_meant in (("near", near, code > 0), ("far", far, code == 2)):
            for name, words in zip(("offset", "t_min", "t_max"), expected):
                found = results[f"{slot}_{name}"]
                assert np.array_equal(found[is_meant], words[is_meant]), f"{slot}_{name} differs"
    else:
        hit, t_entry = oracle.ray_box(operands)
        assert np.array_equal(results["hit"] == 1, hit), f"hits differ first at {np.argmax((results['hit'] == 1) != hit)}"
        assert 0 < hit.sum() < len(hit)
        assert np.array_equal(results["t_entry"][hit], t_entry[hit])


async def run(dut, seed, pauses):
    types = oracle.structures(HEADER)
    operands = oracle.random_operands(types["operands"], COUNT, seed)
    assert operands.itemsize * 8 == len(dut.s_axis_tdata)
    source, sink = await start(dut)
    if pauses:
        rng = random.Random(seed)
        source.set_pause_generator(rng.random() < 0.3 for _ in itertools.count())
        sink.set_pause_generator(rng.random() < 0.5 for _ in itertools.count())
    began = cocotb.utils.get_sim_time("ns")
    data, tags = await transfer(source, sink, operands)
    cycles = (cocotb.utils.get_sim_time("ns") - began) / 10
    assert tags == [position % 2 for position in range(COUNT)]
    judge(operands, np.frombuffer(data, types["result"]))
    if not pauses:
        assert cycles < COUNT + 20, f"{COUNT} results took {cycles} cycles"


@cocotb.test()
async def one_result_a_cycle(dut):
    await run(dut, seed=1, pauses=False)


@cocotb.test()
async def random_back_pressure(dut):
    await run(dut, seed=2, pauses=True)
