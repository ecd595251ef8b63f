O1 (NUL-12)
#3006=#0 (HELLO) (expect alarm PS0119)
M30
