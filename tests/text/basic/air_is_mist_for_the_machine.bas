air(1)
air(0)
' (finally records: coolant mist; coolant off; end)
