O1 (G28G91Z3. is incremental though G91 comes last)
G90 G0 Z5.
G28G91Z3. (expect moves: rapid Z8; rapid Z0)
M30
