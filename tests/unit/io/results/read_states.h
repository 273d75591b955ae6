// States in files of Exodus II, read back with VTK's own reader.

#pragma once

#include <vtkExecutive.h>
#include <vtkExodusIIReader.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <string>
#include <vector>

#include "io/results/state_series.h"
#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::io {

class ReadStates : public VtkFiles {
  protected:
    StateSeries states(const std::string& name) const {
        return {folder_.string(), name, provenance_};
    }
    /// All of a state's points, and its fields, once the reader has been told to read them.
    vtkUnstructuredGrid* read(const std::string& name, double time, bool moved = false) {
        auto* blocks = blocks_of(name, time, moved);
        return blocks ? vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0)) : nullptr;
    }
    /// The same of all element blocks; `by`: a factor of the displacements.
    vtkMultiBlockDataSet* blocks_of(const std::string& name, double time, bool moved,
                                    double by = 1) {
        reader_ = vtkSmartPointer<vtkExodusIIReader>::New();
        reader_->SetSqueezePoints(false);  // all points in the file's order
        reader_->SetFileName(at(name).c_str());
        reader_->SetApplyDisplacements(moved);
        reader_->SetDisplacementMagnitude(by);
        reader_->UpdateInformation();
        for (const int kind :
             {vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK, vtkExodusIIReader::GLOBAL})
            for (int i = 0; i < reader_->GetNumberOfObjectArrays(kind); ++i)
                reader_->SetObjectArrayStatus(kind, i, 1);
        reader_->UpdateTimeStep(time);
        return vtkMultiBlockDataSet::SafeDownCast(reader_->GetOutput()->GetBlock(0));
    }
    std::vector<double> times() {
        auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
        vtkInformation* information = reader_->GetExecutive()->GetOutputInformation(0);
        const double* begin = information->Get(key);
        return {begin, begin + information->Length(key)};
    }
    vtkSmartPointer<vtkExodusIIReader> reader_;
};

}  // namespace tricontact::io
