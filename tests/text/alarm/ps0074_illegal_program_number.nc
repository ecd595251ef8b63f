O0 (PS0074: there is no program 0) (expect alarm PS0074)
M30
