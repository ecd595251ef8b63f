(run with: --machine lathe2)
O1 (Q of the first block)
G97S500M03
G00X34.Z5.
G76P010060Q1500R.05
G76X27.4Z-25.P1300Q400F2. (expect alarm PS0316)
M30
