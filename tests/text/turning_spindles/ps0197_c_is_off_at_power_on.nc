(run with: --machine lathe3c --machine-set m_codes.c_axis_on=18)
O1 (C axis)
G50C0
G28H0 (expect alarm PS0197)
M30
