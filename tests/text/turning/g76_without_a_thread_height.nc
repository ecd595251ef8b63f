(run with: --machine lathe2)
O1 (G76 without a thread height)
G97S500M03
G00X34.Z5.
G76P010060Q100R.05
G76X27.4Z-25.Q400F2.
M30
(finally alarm PS0317)
