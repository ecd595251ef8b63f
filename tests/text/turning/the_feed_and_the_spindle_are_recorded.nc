(run with: --machine lathe2)
O1 (G50 S, G96, G97 and both feed modes)
G50S2500
G96S180M03
G00X50.Z2.
G01Z-1.F.2 (expect moves: line Z-1 F0.2)
G98G01Z-2.F120 (expect moves: line Z-2 F120)
G97S800
M05
M30
(finally records: spindle cw 180; spindle cw 800; spindle stop)
