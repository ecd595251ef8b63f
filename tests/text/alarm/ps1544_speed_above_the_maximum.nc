(run with: --param 3772=8000)
O1 (PS1544: the spindle turns at most 8000)
S12000 M03 (expect alarm PS1544 at S12000)
M30
