(run with: --machine lathe2)
O1 (Spindle and feed)
G50S2000
G96S100M03
G00X30.Z8.
G32Z-20.F2. (expect assumed: a thread under G96 keeps the speed that the spindle has where it begins)
M30
