(run with: --machine lathe2)
O1 (G76 with a tip angle that is none)
G97S500M03
G00X34.Z5.
G76P010045Q100R.05
G76X27.4Z-25.P1300Q400F2.
M30
(finally alarm PS0315)
