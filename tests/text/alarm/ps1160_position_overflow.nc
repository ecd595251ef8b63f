(run with: --max-motions 10000)
O1 (PS1160, WCS-7: 999 metres further again and again)
G91 G00
N1 X999999. (expect alarm PS1160)
GOTO 1
M30
