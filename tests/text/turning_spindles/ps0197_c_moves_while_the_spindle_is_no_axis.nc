(run with: --machine lathe3c --machine-set m_codes.c_axis_on=18,110 --machine-set m_codes.c_axis_off=20)
O1 (C axis)
G98M110
G00C30. (expect moves: rapid C30)
M18C40. (expect moves: rapid C40)
M20
G00H5. (expect alarm PS0197)
M30
(finally records: mcode 110; mcode 18; mcode 20)
