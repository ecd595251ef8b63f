(run with: --machine mill4 --dialect fanuc-lathe --param CCR=1)
O1 (a machine with an axis A: parameter CCR gives the letter to angles; X of this machine is no diameter)
G98 G00 X10. Z0.
G01 X20. A150. F100 (expect moves: line X20 Z-17.3205 A0)
M30
