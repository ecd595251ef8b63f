(run with: --skip-at Z=-12.5)
O1 (section 3.4: the offset is moved by what was measured)
G90 G31 Z-20. F50
#5223=#5223+#5063
#100=#5003 (expect #100=0)
G00 Z1. (expect moves: rapid Z-11.5)
M30
