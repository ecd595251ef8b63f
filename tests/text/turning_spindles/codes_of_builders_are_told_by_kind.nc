(run with: --machine lathe3c --machine-set m_codes.bar_feeder=70 --machine-set m_codes.catcher=73,74 --machine-set m_codes.clamp=68,69)
O1 (Codes of builders)
M68
M70 (expect assumed: M70 is a code of the bar feeder)
M73 (expect assumed: M73 is a code of the parts catcher)
M74
M101 (expect assumed: M101 may be a wait code of two turrets)
M102
M203 (expect assumed: M203 may be a code of the sub-spindle)
M61 (expect assumed: M61 is the builder's)
M62
M30
(finally records: mcode 68; mcode 70; mcode 73; mcode 74; mcode 101; mcode 102; mcode 203; mcode 61; mcode 62)
