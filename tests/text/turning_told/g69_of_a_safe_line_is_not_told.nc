(run with: --machine lathe2)
O1 (Second turret)
G69
M30
(finally assumed: none)
