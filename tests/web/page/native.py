"""The native library, for programs that cannot load it: a line of JSON in, one out.

["function", argument …]: a number; a list of numbers, which comes with its size; {"out": n}, room for n numbers;
{"one": 1}, room for a handle; {"whole": n}, an integer; {"size": n}, a size; {"handle": n}. The answer has what the outputs hold.
usage: native.py LIBRARY
"""
import json
import sys
from ctypes import CDLL, byref, c_char_p, c_double, c_int, c_size_t, c_void_p

library = CDLL(sys.argv[1])
library.goishi_message.restype = c_char_p


def call(name, arguments):
    passed, outs = [], []
    for argument in arguments:
        if isinstance(argument, list):
            passed += [(c_double * len(argument))(*argument), c_size_t(len(argument))]
        elif isinstance(argument, dict) and "out" in argument:
            outs.append((c_double * argument["out"])())
            passed += [outs[-1], c_size_t(argument["out"])]
        elif isinstance(argument, dict) and "one" in argument:
            outs.append(c_void_p())
            passed.append(byref(outs[-1]))
        elif isinstance(argument, dict) and "whole" in argument:
            passed.append(c_int(argument["whole"]))
        elif isinstance(argument, dict) and "handle" in argument:
            passed.append(c_void_p(argument["handle"]))
        elif isinstance(argument, dict) and "size" in argument:
            passed.append(c_size_t(argument["size"]))
        else:
            passed.append(c_double(argument))
    if getattr(library, "goishi_" + name)(*passed) != 0:
        return {"message": library.goishi_message().decode()}
    return {"outs": [out.value if isinstance(out, c_void_p) else list(out) for out in outs]}


for line in sys.stdin:
    name, *arguments = json.loads(line)
    print(json.dumps(call(name, arguments)), flush=True)
