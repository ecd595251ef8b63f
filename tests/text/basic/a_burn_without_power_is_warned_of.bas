burn(0.1) ' (expect warning LW0003 at burn)
' (finally records: dwell 0.1)
