(run with: --machine lathe2)
O1 (T in a G50 block)
G97S500M03
G50X100.Z50.T0101
M30
(finally alarm PS0245)
